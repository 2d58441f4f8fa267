"""Write a migration for what changed in the schema: ``.venv/bin/python migrations/new.py "add the column x"``.

Read the result before you commit it, and raise SCHEMA_VERSION in esicatalog/catalog/schema.py.
"""

import re
import subprocess
import sys
import textwrap
from pathlib import Path

import sqlalchemy as sa
from alembic.autogenerate import produce_migrations, render_python_code
from alembic.migration import MigrationContext

from esicatalog.catalog import database, schema, views

SHORT_TYPES = {
    "sa.BigInteger().with_variant(sa.Integer(), 'sqlite')": "INTEGER",
    "sa.Boolean().with_variant(sa.Integer(), 'sqlite')": "BOOLEAN",
    "sa.Text().with_variant(sa.Text(collation='C'), 'postgresql')": "TEXT",
    "sa.Double().with_variant(sa.REAL(), 'sqlite')": "REAL",
    "sa.LargeBinary().with_variant(sa.BLOB(), 'sqlite')": "BLOB",
}
TEMPLATE = '''"""{message}"""

import sqlalchemy as sa
from alembic import op

revision = "{revision}"
down_revision = {down_revision!r}

{types}


def upgrade() -> None:
{body}


def downgrade() -> None:
    raise NotImplementedError("a catalog is never downgraded: ingest the files again with the older version")
'''


def main(message: str) -> None:
    """Compare a database at the newest migration with the schema and write what is missing."""
    versions = Path(__file__).parent / "versions"
    existing = sorted(path.stem[:4] for path in versions.glob("[0-9]*.py"))
    revision = f"{len(existing) + 1:04d}"
    engine = sa.create_engine("sqlite://", poolclass=sa.StaticPool)
    if existing:
        database.upgrade(engine)
    with engine.connect() as connection:
        views.drop_views(connection)
        context = MigrationContext.configure(connection, opts={"render_as_batch": bool(existing)})
        operations = produce_migrations(context, schema.metadata)
        body = render_python_code(operations.upgrade_ops, render_as_batch=bool(existing))
    body = "\n".join(line for line in body.splitlines() if "###" not in line)
    for long, short in SHORT_TYPES.items():
        body = body.replace(long, short)
    body = re.sub(r", nullable=True", "", body)
    slug = re.sub(r"\W+", "_", message.lower()).strip("_")[:40]
    text = TEMPLATE.format(
        message=message,
        revision=revision,
        down_revision=existing[-1] if existing else None,
        types="\n".join(f"{short} = {long}" for long, short in SHORT_TYPES.items()),
        body=textwrap.indent(textwrap.dedent(body), "    "),
    )
    path = versions / f"{revision}_{slug}.py"
    path.write_text(text, encoding="utf-8")
    for command in (["check", "--fix"], ["format"]):  # an empty migration needs no imports, texts other quotes
        subprocess.run([sys.executable, "-m", "ruff", *command, "--quiet", str(path)], check=True)
    print(path)
    if operations.upgrade_ops.is_empty():
        print(
            "It is empty, for no table differs on SQLite. Right where views changed or what is derived. Comments, which "
            "SQLite has none of, are altered by hand for PostgreSQL, as 0011 does it.",
            file=sys.stderr,
        )


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit('say what changes: .venv/bin/python migrations/new.py "add the column x"')
    main(sys.argv[1])
