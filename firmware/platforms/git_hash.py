"""Tells the firmware which commit it is of, where git knows."""

import subprocess

Import("env")  # noqa: F821  PlatformIO's

done = subprocess.run(
    ["git", "rev-parse", "--short=12", "HEAD"], capture_output=True, text=True, check=False
)
if done.returncode == 0:
    env.Append(CPPDEFINES=[("RELIEFSCOPE_GIT_HASH", f'\\"{done.stdout.strip()}\\"')])  # noqa: F821
