# Every target sets up what it needs first, and a second run skips what is there.

SHELL := /bin/bash
# QGIS is bound to the system's Python, and looks for its home along PATH: nothing here
# may meet another one.
PYTHON := /usr/bin/python3
export PATH := /usr/bin:/bin:$(PATH)
VENV_PYTHON := .venv/bin/python
# Passed on to pytest, as in `make test ARGS="tests/radiography -k flux"`.
ARGS :=

# Libraries of the user's own would be seen by the tests, but not by the next machine.
unexport PYTHONPATH PYTHONHOME
export PYTHONNOUSERSITE := 1

.DEFAULT_GOAL := help
.PHONY: help demo test lint audit fuzz soak qgis bench sky reference models translations screenshots validation experiments matrix package clean packages development-packages document-packages

help: ## Show this list
	@grep -hE '^[a-z]+:.*##' Makefile | sed -E 's/^([a-z]+):.*## /\1\t/' \
		| while IFS=$$'\t' read -r name what; do printf '  make %-12s %s\n' "$$name" "$$what"; done

demo: packages ## Simulate a muogram of Vesuvius from the command line, into build/demo
	@$(PYTHON) tools/demo.py

test: .venv/ready ## Run the tests (ARGS="…" goes to pytest)
	@QT_QPA_PLATFORM=offscreen $(VENV_PYTHON) -m pytest $(ARGS)

lint: .venv/ready ## Check style and types
	@$(VENV_PYTHON) -m ruff check
	@$(VENV_PYTHON) -m ruff format --check
	@$(VENV_PYTHON) -m mypy muysc_qgis

audit: .venv/ready ## Look for insecure code in what ships, and for secrets in all of it
	@$(VENV_PYTHON) -m bandit --quiet --recursive muysc_qgis processing_algorithms __init__.py
	@git ls-files -z '*.py' '*.md' '*.html' '*.toml' '*.txt' '*.model3' Makefile .ci \
		| xargs -0 $(VENV_PYTHON) -m detect_secrets.pre_commit_hook --no-verify

fuzz: .venv/ready ## Try hostile parameters and files (FUZZ_SECONDS=300, FUZZ_SEED=1)
	@FUZZ_SECONDS=$${FUZZ_SECONDS:-300} FUZZ_SEED=$${FUZZ_SEED:-1} \
		$(VENV_PYTHON) -m pytest --capture=no tests/fuzz $(ARGS)

sky: ## Make the table of the muon sky again, which takes half an hour (needs PyPI)
	@tools/muon_sky/run

soak: packages ## Run a thousand radiographies in one process and watch its memory
	@$(PYTHON) -m tools.soak

qgis: packages ## Open QGIS with the plugin and Vesuvius, in a profile of its own
	@tools/desktop

bench: .venv/ready ## Measure time and memory, side by side with other codes
	@for script in $(filter-out benchmarks/measure.py,$(wildcard benchmarks/*.py)); do \
		PYTHONPATH="$(CURDIR)" $(VENV_PYTHON) "$$script" || exit; done

reference: packages ## Write docs/algorithms.md and docs/reference from what the algorithms declare
	@$(PYTHON) -m tools.make_reference
	@$(PYTHON) -m tools.reference_pages

models: packages ## Write the models that come with the provider
	@QT_HASH_SEED=0 $(PYTHON) -m tools.make_models

translations: document-packages ## Gather what is to be translated, and compile i18n
	@$(PYTHON) -m tools.translations

screenshots: document-packages ## Take the pictures of the user guide, into docs/images
	@$(PYTHON) tools/screenshots.py

validation: .venv/ready ## Compare our numbers with others', into build/validation and docs
	@$(VENV_PYTHON) -m tools.validation

experiments: .venv/ready ## Reconstruct known mountains beside the truth (ARGS=--quick)
	@$(VENV_PYTHON) -m tools.experiments $(ARGS)
	@$(VENV_PYTHON) -m tools.count_experiments $(ARGS)

matrix: ## Run the tests on QGIS 3.22, 3.40 and 3.44 (ARGS="--only sid", or for pytest)
	@$(PYTHON) tools/matrix.py $(ARGS)

package: ## Pack the last commit as a zip that QGIS installs, into build
	@$(PYTHON) tools/package.py

clean: ## Remove everything made here, .venv too
	@rm -rf build .venv .hypothesis .pytest_cache .mypy_cache .ruff_cache
	@find . -name __pycache__ -type d -prune -exec rm -rf {} +

packages:
	@tools/debian_packages run

development-packages:
	@tools/debian_packages develop

document-packages:
	@tools/debian_packages document

.venv/ready: tools/requirements.txt tools/development_tools | development-packages
	@tools/development_tools
