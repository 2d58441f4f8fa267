"""Opening, creating and upgrading catalogs. Alembic is imported only when there is something to migrate."""

import contextlib
import os
import re
import sqlite3
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import sqlalchemy as sa

from esicatalog.catalog import schema, views
from esicatalog.catalog.driver_errors import damage_error, database_error, driver_message
from esicatalog.catalog.full_text import index_devices
from esicatalog.catalog.lock import only_writer
from esicatalog.catalog.schema import SCHEMA_VERSION
from esicatalog.catalog.turns import take_turn
from esicatalog.errors import CatalogError
from esicatalog.resources import resource

NEW_CATALOG = "new_catalog.sql"
"""What the migrations make of an empty SQLite file, written down beside them by docs/generate.py."""
STATEMENT_END = ";\n\n"
"""Between the statements in there."""

_DRIVERS = {
    "sqlite": "sqlite",
    "sqlite+pysqlite": "sqlite",
    "postgres": "postgresql+psycopg",
    "postgresql": "postgresql+psycopg",
    "postgresql+psycopg": "postgresql+psycopg",
    "cockroachdb": "cockroachdb+psycopg",
    "cockroachdb+psycopg": "cockroachdb+psycopg",
}
"""How a URL may begin, and what that means; others are refused."""
_SECRET_OPTION = re.compile(r"(?<=[?&])(\w*(?:pass|secret)\w*)=[^&]*")
"""What libpq takes as an option that no message may show: password, sslpassword, passfile, oauth_client_secret."""
_NO_FILE = re.compile(
    r"(?:postgres|postgresql|cockroachdb|sqlite)(?:\+\w+)?(?::|//)|(?:.*\s)?(?:host|dbname|password|service)\s*=",
    re.IGNORECASE,
)
"""How texts begin that mean a database and are no URL: ``postgresql:…``, and the ``name=value …`` of libpq."""
_OWN_TABLES = ("alembic_version", "device_sources")
"""By which a catalog is known."""
_SCHEMA_OF_CATALOG = f"""
    SELECT quote_ident(name), place FROM unnest(current_schemas(false)) WITH ORDINALITY AS path (name, place)
    WHERE (SELECT count(*) FROM pg_tables WHERE schemaname = name AND tablename IN {_OWN_TABLES}) = {len(_OWN_TABLES)}
    ORDER BY place LIMIT 1
"""
"""Where on the search path of a server's user the first catalog lies."""


def catalog_url(target: str | os.PathLike[str]) -> sa.URL:
    """The SQLAlchemy URL of a file path or of a URL text. Raises :class:`CatalogError`."""
    text = os.fspath(target)
    if not text or "\0" in text:
        raise CatalogError(f"the name of the catalog {'holds a NUL' if text else 'is empty'}; name a file")
    if "://" not in text:
        if _NO_FILE.match(text):
            # The text may hold a password.
            raise CatalogError("neither a file nor a URL; write postgresql+psycopg://USER@HOST/DATABASE")
        return _with_file(sa.URL.create("sqlite", database=text))
    try:
        url = sa.make_url(text)
    except (sa.exc.ArgumentError, ValueError) as error:
        raise CatalogError("not a database URL; write postgresql+psycopg://USER:PASSWORD@HOST/DATABASE") from error
    if any("@" in (part or "") for part in (url.host, url.database if url.password is not None else None)):
        # What stands before that @ is the end of a password, which messages would show.
        raise CatalogError("the database URL has more than one @; write one in a password as %40")
    if url.drivername not in _DRIVERS:
        raise CatalogError(
            f"{shown_url(url)}: no catalog can be at {url.drivername}://; write the path of an SQLite file or "
            "postgresql+psycopg://…"
        )
    if url.get_backend_name() == "sqlite" and (url.query or (url.database or "").startswith("file:")):
        # Left alone, an option such as mode=ro would silently be ignored.
        raise CatalogError(
            f"{shown_url(url)}: SQLite URLs take no options and no file: names; give the path of the catalog"
        )
    return _with_file(url.set(drivername=_DRIVERS[url.drivername]))


def _with_file(url: sa.URL) -> sa.URL:
    """The same URL. Raises :class:`CatalogError` for SQLite in memory, of which each connection has its own."""
    if url.get_backend_name() == "sqlite" and url.database in (None, "", ":memory:"):
        raise CatalogError("a catalog needs a file, not memory; name one")
    return url


def shown_target(target: str | os.PathLike[str]) -> str:
    """A catalog as messages name it: without the password."""
    return shown_url(catalog_url(target))


def shown_url(url: sa.URL) -> str:
    """As :func:`shown_target`; an SQLite catalog is its file."""
    is_file = sqlite_path(url) is not None and not url.query
    return str(url.database) if is_file else _SECRET_OPTION.sub(r"\1=***", repr(url))


def sqlite_path(url: sa.URL) -> Path | None:
    """The file of an SQLite catalog, None for other databases."""
    return Path(str(url.database)) if url.get_backend_name() == "sqlite" else None


def make_engine(url: sa.URL, read_only: bool = False) -> sa.Engine:
    """An engine with foreign keys enforced and short waits for locks; ``read_only`` refuses every write.

    Its connections are all to the file that a path or link meant at first. Raises :class:`CatalogError` where the
    driver is missing; connecting raises it when the file was replaced.
    """
    options: dict[str, Any] = {}
    path = sqlite_path(url)
    if path is not None:
        file = Path(os.path.realpath(path))
        url, options = url.set(database=str(file)), {"creator": _connector(file)}
    else:
        # Whoever waited for its turn to write has to see what the others wrote, whatever the server's default is.
        options = {
            "isolation_level": "READ COMMITTED",
            "execution_options": {"postgresql_readonly": read_only},
            "connect_args": {"client_encoding": "utf8"},
        }
    try:
        engine = sa.create_engine(url, **options)
    except (ModuleNotFoundError, sa.exc.NoSuchModuleError) as error:
        raise CatalogError(
            f"{shown_url(url)}: the driver of {url.drivername} is not installed ({error}); "
            "PostgreSQL's comes with: pip install 'esicatalog[postgres]'"
        ) from error
    if path is not None:

        @sa.event.listens_for(engine, "connect")
        def _configure(connection: sqlite3.Connection, record: Any) -> None:
            connection.execute("PRAGMA foreign_keys = ON")
            connection.execute("PRAGMA busy_timeout = 5000")
            if read_only:
                connection.execute("PRAGMA query_only = ON")

    else:
        # Before SQLAlchemy asks the first connection how its server reads texts.
        sa.event.listen(engine, "connect", _prepare_session, insert=True)
    return engine


def _prepare_session(connection: Any, record: Any) -> None:
    """Make a server's session read texts as SQL says, and keep to the schema of the catalog.

    Servers, databases and users may have backslashes in texts stand for other characters; bytes that are copied in
    would be stored wrong. All of a catalog lies in one schema: nothing is made or found in those that stand before it
    on the search path. Where it stands first the path stays as it is, and a new catalog is made in the first schema.
    """
    with connection.cursor() as cursor:
        cursor.execute("SET standard_conforming_strings TO on")
        found = cursor.execute(_SCHEMA_OF_CATALOG).fetchone()
        if found is not None and found[1] > 1:
            cursor.execute(f"SET search_path TO {found[0]}")
    connection.commit()


def _connector(file: Path) -> Callable[[], sqlite3.Connection]:
    """What connects to one file: two connections to different ones would answer with two catalogs.

    The first connection makes it if it is not there.
    """
    opened: list[os.stat_result] = []

    def connect() -> sqlite3.Connection:
        if opened and not (file.exists() and os.path.samestat(file.stat(), *opened)):
            raise CatalogError(f"{file}: is not the file any more that was opened; open the catalog again")
        mode = "rw" if opened else "rwc"
        connection = sqlite3.connect(f"{file.as_uri()}?mode={mode}", uri=True, check_same_thread=False)
        if not opened:
            opened.append(file.stat())
        return connection

    return connect


def reading_connection(engine: sa.Engine) -> sa.Connection:
    """A connection whose transactions see one state of the catalog, whatever others write meanwhile.

    On SQLite every statement sees what is committed.
    """
    connection = engine.connect()
    if connection.dialect.name == "sqlite":
        return connection
    return connection.execution_options(isolation_level="REPEATABLE READ", postgresql_readonly=True)


def open_catalog(
    target: str | os.PathLike[str],
    create: bool = False,
    read_only: bool = False,
    when_new: Callable[[], object] = lambda: None,
) -> sa.Engine:
    """Open a catalog of the current schema version, creating it through the migrations when asked.

    ``when_new`` is called before one is made, which takes a second on a server. Raises :class:`CatalogError` with what
    to do when there is none, or when it is older, newer or no catalog.
    """
    path = sqlite_path(catalog_url(target))
    if create and path is not None and not path.exists() and not path.parent.is_dir():
        raise CatalogError(f"{path.parent}: no such folder for the catalog")
    engine, version = _connected(target, create, read_only)
    with _disposed_of_when_refused(engine, target, is_writing=True):
        if version is None:
            when_new()
            version = _create(engine)
        if version != SCHEMA_VERSION:
            raise CatalogError(_version_message(shown_target(target), version))
    return engine


@contextlib.contextmanager
def _disposed_of_when_refused(
    engine: sa.Engine, target: str | os.PathLike[str], is_writing: bool = False
) -> Iterator[None]:
    """Close the connections of an engine that nobody gets; errors of the database become :class:`CatalogError`."""
    try:
        yield
    except BaseException as error:
        engine.dispose()
        if isinstance(error, sa.exc.DBAPIError):
            raise database_error(shown_target(target), error, is_writing) from error
        raise


def _create(engine: sa.Engine) -> str:
    """Make the tables; of several that begin at once one makes them, the others find them made."""
    if engine.dialect.name == "sqlite":
        return _create_file(engine)
    try:
        upgrade(engine, only_new=True)
    except sa.exc.DBAPIError:
        with engine.connect() as connection:
            made_by_another = schema_version(connection)
        if made_by_another is None:
            raise
        return made_by_another
    return SCHEMA_VERSION


def _create_file(engine: sa.Engine) -> str:
    """A new file holds what the migrations make of it; running them takes longer than many an ingest."""
    with engine.begin() as connection:
        _begin_upgrade(connection)
        made_by_another = schema_version(connection)
        if made_by_another is not None:
            return made_by_another
        for statement in (resource("migrations") / NEW_CATALOG).read_text("utf-8").split(STATEMENT_END):
            connection.exec_driver_sql(statement)
    return SCHEMA_VERSION


def _begin_upgrade(connection: sa.Connection) -> None:
    """Python's sqlite3 begins no transaction for CREATE: who is killed would leave half a catalog."""
    connection.exec_driver_sql("BEGIN IMMEDIATE")


def _connected(target: str | os.PathLike[str], create: bool, read_only: bool = False) -> tuple[sa.Engine, str | None]:
    """An engine and the schema version behind it; None, for an empty database, only with ``create``."""
    url = catalog_url(target)
    path = sqlite_path(url)
    if not create and path is not None and not path.exists():
        raise CatalogError(f"{path}: no such catalog; make one with: esicatalog ingest PATH --db {path}")
    engine = make_engine(url, read_only)
    with _disposed_of_when_refused(engine, target):
        try:
            with engine.connect() as connection:
                version = schema_version(connection)
        except UnicodeDecodeError as error:
            # SQLite's message about a damaged schema quotes the damage.
            raise damage_error(shown_target(target), error) from error
        if version is None and not create:
            shown = shown_target(target)
            raise CatalogError(f"{shown}: not a catalog; make one with: esicatalog ingest PATH --db {shown}")
    return engine, version


def upgrade_catalog(target: str | os.PathLike[str]) -> tuple[str, str]:
    """Bring a catalog of an older version to the current schema; returns the versions before and after.

    Raises :class:`CatalogError` when there is no catalog or when it is newer than this version.
    """
    engine, found = _connected(target, create=False)
    version = str(found)
    try:
        if version > SCHEMA_VERSION:
            raise CatalogError(_version_message(shown_target(target), version))
        if version != SCHEMA_VERSION:
            with only_writer(sqlite_path(engine.url)), _beside_readers(engine):
                upgrade(engine)
    except sa.exc.DBAPIError as error:
        raise database_error(shown_target(target), error, is_writing=True) from error
    finally:
        engine.dispose()
    return version, SCHEMA_VERSION


@contextlib.contextmanager
def _beside_readers(engine: sa.Engine) -> Iterator[None]:
    """Wait for those who are reading an SQLite file, as an ingest does; who begins meanwhile reads what was there."""
    from esicatalog.catalog.load import begin_log, end_load

    if engine.dialect.name != "sqlite":
        yield
        return
    with engine.connect() as connection:
        begin_log(connection)
    try:
        yield
    finally:
        with engine.connect() as connection:
            end_load(connection)


def _version_message(target: str, version: str) -> str:
    if version > SCHEMA_VERSION:
        return (
            f"{target}: made by a newer esicatalog (schema {version}, this one knows {SCHEMA_VERSION}); "
            "use that version or ingest into a new catalog"
        )
    return (
        f"{target}: made by an older esicatalog (schema {version}); upgrade it with: esicatalog migrate --db {target}"
    )


class DriverQuery:
    """Runs ``?`` statements on the driver of an SQLite catalog, on a connection of its own, for one thread at a time.

    The connection stays open until :meth:`close`, and sees what others commit. The statements raise
    :class:`CatalogError`.
    """

    def __init__(self, engine: sa.Engine) -> None:
        self._connection = engine.connect().execution_options(isolation_level="AUTOCOMMIT")
        driver: Any = self._connection.connection.driver_connection
        self._execute = driver.execute
        self._shown = shown_url(engine.url)
        self._lock = threading.Lock()

    def __call__(self, sql: str, values: tuple[Any, ...]) -> list[tuple[Any, ...]]:
        """All rows of a statement."""
        try:
            with self._lock:
                found: list[tuple[Any, ...]] = self._execute(sql, values).fetchall()
        except sqlite3.Error as error:
            raise CatalogError(driver_message(self._shown, error)) from error
        return found

    def close(self) -> None:
        """Give the connection back to the engine, which may close it."""
        self._connection.close()

    def changes(self) -> int:
        """A number that grows whenever others have committed."""
        return int(self("PRAGMA data_version", ())[0][0])


def schema_version(connection: sa.Connection) -> str | None:
    """The migration a database stands at; None for an empty database; an error for a foreign one."""
    shown = shown_url(connection.engine.url)
    names = set(sa.inspect(connection).get_table_names(views.own_schema(connection)))
    if names.issuperset(_OWN_TABLES):
        versions = connection.execute(sa.text("SELECT version_num FROM alembic_version")).scalars().all()
        if len(versions) != 1:
            raise CatalogError(f"{shown}: does not say its schema version; delete it and ingest again")
        return str(versions[0])
    if names:
        raise CatalogError(f"{shown}: the database holds other tables than a catalog's; name another one")
    return None


def _require_unicode(connection: sa.Connection) -> None:
    encoding = connection.exec_driver_sql("SHOW server_encoding").scalar_one()
    if encoding not in ("UTF8", "UTF-8"):
        raise CatalogError(f"the database has the encoding {encoding}; make one with: createdb -E UTF8 -T template0")


def upgrade(engine: sa.Engine, only_new: bool = False) -> None:
    """Bring a database to the current schema; what a new catalog is, is made the same way.

    With ``only_new`` a catalog that another process has just made is left as it is.
    """
    from alembic import command
    from alembic.config import Config

    from esicatalog.catalog.rederive import derive_again

    config = Config()
    config.set_main_option("script_location", str(resource("migrations")))
    with engine.begin() as connection:
        if connection.dialect.name == "sqlite":
            # A table that is made anew has its name last: views that others have made refer to it all the time.
            connection.exec_driver_sql("PRAGMA legacy_alter_table = ON")
            _begin_upgrade(connection)
        is_new = schema_version(connection) is None
        if only_new and not is_new:
            return
        if not is_new:
            take_turn(connection)
            views.drop_views(connection)
        elif connection.dialect.name != "sqlite":
            _require_unicode(connection)
        config.attributes["connection"] = connection
        command.upgrade(config, "head")
        if not is_new:
            derive_again(connection)
        views.create_views(connection)
        index_devices(connection, connection.execute(sa.select(schema.devices.c.id)).scalars().all())
