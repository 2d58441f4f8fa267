"""``python -m esicatalog``."""

from esicatalog.cli.main import cli

if __name__ == "__main__":
    cli(prog_name="esicatalog")
