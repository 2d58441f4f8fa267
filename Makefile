# Two commands do everything on a machine with Python: make serve, make test.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
ESI ?= data
DB ?= catalog.db
PORT ?= 8001
CORPUS ?= $(or $(ESICATALOG_CORPUS),../shared/corpus)

.PHONY: install serve test lint test-corpus bench docs screenshot clean

install: $(VENV)/installed

$(VENV)/installed: pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev]'
	touch $@

serve: install
	$(BIN)/esicatalog ingest $(ESI) --db $(DB)
	$(BIN)/esicatalog serve --db $(DB) --port $(PORT)

test: install lint
	$(BIN)/python -m pytest -m 'not corpus'

lint: install
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports

test-corpus: install
	ESICATALOG_CORPUS=$(CORPUS) $(BIN)/python -m pytest -m corpus

bench: install
	$(BIN)/python benchmarks/ingest.py $(CORPUS)/esi
	$(BIN)/python benchmarks/queries.py $(CORPUS)/esi

docs: install
	$(BIN)/python docs/generate.py

clean:
	rm -rf $(VENV) dist build .pytest_cache .mypy_cache .ruff_cache
