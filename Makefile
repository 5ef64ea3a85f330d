# Each target is one command; each makes or reuses .venv by itself (see tools/bootstrap).
VENV ?= .venv
BIN := $(VENV)/bin
export VENV

.PHONY: help demo test lint format generate bench soak fuzz firmware firmware-test docs clean

help:  ## show this list
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:.*## /\t/' | expand -t 12

demo:  ## measure the fiducial on the simulated instrument, full size
	@tools/bootstrap
	$(BIN)/reliefscope demo $(DEMO_OPTIONS)

test:  ## the fast tests
	@tools/bootstrap test lint
	$(BIN)/python -m pytest -n 2 $(PYTEST_OPTIONS)

lint:  ## formatters, linters, strict types, generated files up to date
	@tools/bootstrap test lint
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/python -m protocol.generator --check
	git ls-files 'firmware/*.cpp' 'firmware/*.hpp' 'firmware/*.h' 'tests/firmware/*.cpp' 'tests/firmware/*.hpp' \
	  | grep -v /generated/ | xargs $(BIN)/clang-format --dry-run --Werror

format:  ## rewrite the sources in the house style
	@tools/bootstrap test lint
	$(BIN)/ruff check --fix-only .
	$(BIN)/ruff format .
	git ls-files 'firmware/*.cpp' 'firmware/*.hpp' 'firmware/*.h' 'tests/firmware/*.cpp' 'tests/firmware/*.hpp' \
	  | grep -v /generated/ | xargs $(BIN)/clang-format -i

generate:  ## write the files made from protocol/protocol.yml
	@tools/bootstrap test lint
	$(BIN)/python -m protocol.generator

bench:  ## benchmarks beside their peers, in one run
	@tools/bootstrap test lint
	$(BIN)/python -m bench

soak:  ## the long tests
	@tools/bootstrap test lint
	$(BIN)/python -m pytest -m soak $(PYTEST_OPTIONS)

firmware:  ## every firmware image that this machine can build; FIRMWARE=all fetches the Teensy's tools, too
	@tools/bootstrap test lint
	tools/firmware $(FIRMWARE)

firmware-test:  ## the firmware's tests: with sanitizers here, as ARM code in an emulator where there is one
	@tools/bootstrap test lint
	$(BIN)/python -m pytest tests/firmware tests/e2e $(PYTEST_OPTIONS)

fuzz:  ## fuzz the firmware's core for FUZZ_SECONDS (60)
	@tools/fuzz

docs:  ## the manual as web pages, in build/docs
	@tools/bootstrap docs test lint
	$(BIN)/sphinx-build -q -W -b html docs build/docs
	@echo "open build/docs/index.html"

clean:  ## remove the environment and everything built; runs are kept
	rm -rf $(VENV) build .mypy_cache .ruff_cache .pytest_cache
