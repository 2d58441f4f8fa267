# Two commands do everything on a machine with Python: make serve, make test.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
ESI ?= data
DB ?= catalog.db
PORT ?= 8001
CORPUS ?= $(or $(ESICATALOG_CORPUS),../shared/corpus)

.PHONY: install serve test test-datasette-1 lint test-corpus faults bench docs screenshots clean

install: $(VENV)/installed

$(VENV)/installed: pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev]'
	touch $@

serve: install
	$(BIN)/esicatalog ingest $(ESI) --db $(DB)
	$(BIN)/esicatalog serve --db $(DB) --port $(PORT)

test: install lint
	$(BIN)/python -m pytest -m 'not corpus and not faults'

# The web pages and routes once more, on the coming line of Datasette.
test-datasette-1: $(VENV)-datasette-1/installed
	$(VENV)-datasette-1/bin/python -m pytest -m 'not corpus and not faults' tests/test_server.py tests/test_datasette.py tests/test_identify.py tests/test_pages.py tests/test_browser.py

$(VENV)-datasette-1/installed: pyproject.toml
	$(PYTHON) -m venv $(VENV)-datasette-1
	$(VENV)-datasette-1/bin/python -m pip install --quiet --disable-pip-version-check --pre --editable '.[dev]' 'datasette>=1.0a41,<2'
	touch $@

lint: install
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports

test-corpus: install
	ESICATALOG_CORPUS=$(CORPUS) $(BIN)/python -m pytest -m corpus

# Half an hour: kills at random moments, many clients for a minute. ESICATALOG_SEED chooses other moments.
faults: install
	ESICATALOG_CORPUS=$(CORPUS) $(BIN)/python -m pytest -m faults

bench: install
	$(BIN)/python benchmarks/ingest.py $(CORPUS)/esi
	$(BIN)/python benchmarks/queries.py $(CORPUS)/esi
	$(BIN)/python benchmarks/identify.py $(CORPUS)/esi
	$(BIN)/python benchmarks/pages.py $(CORPUS)/esi

docs: install
	$(BIN)/python docs/generate.py

screenshots: install
	$(BIN)/python docs/screenshots.py

clean:
	rm -rf $(VENV) $(VENV)-datasette-1 dist build .pytest_cache .mypy_cache .ruff_cache
