"""PlatformIO's reader of the unit tests: their lines are Unity's, but no library is needed."""

from platformio.test.runners.unity import UnityTestRunner


class CustomTestRunner(UnityTestRunner):
    """Unity without fetching Unity."""

    EXTRA_LIB_DEPS = None

    def configure_build_env(self, env):
        return env
