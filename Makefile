# Two commands do everything on a machine with Python: make serve, make test.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
DATASETTE_1 := $(VENV)/datasette-1
ESI ?= data
DB ?= catalog.db
PORT ?= 8001
FUZZ_SECONDS ?= 60
CORPUS ?= $(or $(ESICATALOG_CORPUS),../shared/corpus)

# Every command and every test starts many processes: what they load is compiled once.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: install serve test test-datasette-1 lint test-corpus fuzz faults bench bench-scale docs dump screenshots clean

install: $(VENV)/installed

$(VENV)/installed: pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev]'
	touch $@

# Exit code 1 of ingest names documents that failed; the others are served.
serve: install
	$(BIN)/esicatalog ingest "$(ESI)" --db "$(DB)" || test $$? -eq 1
	$(BIN)/esicatalog serve --db "$(DB)" --port $(PORT)

test: install lint
	$(BIN)/python -m pytest -n auto --dist loadfile --no-loadscope-reorder -m 'not corpus and not faults'

# The web pages and routes once more, on the coming line of Datasette, which would close after each test what it made.
test-datasette-1: $(DATASETTE_1)/installed
	PYTHONPATH=$(CURDIR)/$(DATASETTE_1) $(BIN)/python -m pytest -n auto --dist loadfile -m 'datasette and not corpus and not faults' -o datasette_autoclose=false

# A folder that is searched before the packages of the environment.
$(DATASETTE_1)/installed: $(VENV)/installed
	rm -rf $(DATASETTE_1)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --target $(DATASETTE_1) 'datasette>=1.0a41,<2'
	touch $@

lint: install
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports

test-corpus: install
	ESICATALOG_CORPUS=$(CORPUS) $(BIN)/python -m pytest -n auto --dist loadfile -m corpus

# Looks for inputs that are answered neither with a result nor with a named error, FUZZ_SECONDS for each target.
fuzz: install
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[fuzz]'
	ESICATALOG_CORPUS=$(CORPUS) FUZZ_SECONDS=$(FUZZ_SECONDS) $(BIN)/python -m fuzz

# Half an hour: kills at random moments, many clients for a minute. ESICATALOG_SEED chooses other moments.
faults: install
	ESICATALOG_CORPUS=$(CORPUS) $(BIN)/python -m pytest -m faults

# --write docs/performance.md puts the table into the documentation.
bench: install
	$(BIN)/python benchmarks/run.py $(CORPUS)/esi
	$(BIN)/python benchmarks/postgres.py $(CORPUS)/esi

# 10,000 and 100,000 made-up devices: some minutes, 3 GB in the temporary folder.
bench-scale: install
	$(BIN)/python benchmarks/scale.py

docs: install
	$(BIN)/python docs/generate.py

# Before the schema changes: what the upgrade tests have of the version that was released.
dump: install
	$(BIN)/python migrations/dump.py

screenshots: install
	$(BIN)/python docs/screenshots.py

clean:
	rm -rf $(VENV) dist build .pytest_cache .mypy_cache .ruff_cache
