"""A PostgreSQL of one's own: in a temporary folder, reached by a socket in it, gone afterwards."""

import contextlib
import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

_DEBIAN_FOLDERS = Path("/usr/lib/postgresql")
_SERVER_USER = "postgres"
"""Who runs the server where we are root, which PostgreSQL refuses to be; and the owner of all databases."""
_NO_NETWORK = "-c listen_addresses=''"
"""The socket's folder is all there is to reach the server by."""
_CARELESS = "-c fsync=off -c full_page_writes=off"


class NoServer(Exception):
    """There is no PostgreSQL to start; the text says what is missing."""


class Cluster:
    """A running server; every database asked for is new and empty."""

    def __init__(self, socket_folder: Path, run: Sequence[str], programs: Path) -> None:
        self._socket_folder = socket_folder
        self._run = run
        self._programs = programs
        self._count = 0

    def new_database(self, *options: str) -> str:
        """The URL of an empty database; ``options`` are those of createdb."""
        self._count += 1
        name = f"catalog_{self._count}"
        command = [self._programs / "createdb", "-h", self._socket_folder, "-U", _SERVER_USER, *options, name]
        subprocess.run([*self._run, *map(str, command)], check=True, capture_output=True)
        return f"postgresql+psycopg://{_SERVER_USER}@/{name}?host={self._socket_folder}"


def server_programs() -> Path:
    """The folder of initdb and pg_ctl, the newest version first. Raises :class:`NoServer`."""
    folders = sorted(_DEBIAN_FOLDERS.glob("*/bin"), key=lambda folder: float(folder.parent.name), reverse=True)
    found = shutil.which("pg_ctl")
    if found:
        folders.append(Path(found).resolve().parent)
    for folder in folders:
        if all((folder / program).exists() for program in ("initdb", "pg_ctl", "createdb")):
            return folder
    raise NoServer("no PostgreSQL server here (initdb, pg_ctl); on Debian: apt-get install postgresql")


@contextlib.contextmanager
def running_cluster(durable: bool = False) -> Iterator[Cluster]:
    """Make a cluster, start it, and remove it with all its databases. Raises :class:`NoServer`.

    Unless ``durable`` it does not wait for the disk: what is thrown away need not survive a power failure.
    """
    programs = server_programs()
    run: list[str] = []
    with tempfile.TemporaryDirectory(prefix="pg-") as folder:
        if os.geteuid() == 0:
            if shutil.which("runuser") is None:
                raise NoServer("PostgreSQL does not run as root, and there is no runuser to be somebody else with")
            run = ["runuser", "-u", _SERVER_USER, "--"]
            try:
                shutil.chown(folder, _SERVER_USER)
            except LookupError as error:
                raise NoServer(f"PostgreSQL does not run as root, and there is no user {_SERVER_USER}") from error
        cluster, log = Path(folder, "cluster"), Path(folder, "log")

        def call(program: str, *arguments: str) -> None:
            command = [*run, str(programs / program), "-D", str(cluster), *arguments]
            # The server inherits what pg_ctl has open: a pipe would be waited for as long as the server runs.
            with tempfile.TemporaryFile() as output:
                done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=output, stderr=output)
                if done.returncode:
                    output.seek(0)
                    raise NoServer(f"{program}: {output.read().decode('utf-8', 'replace').strip()}")

        call("initdb", "-U", _SERVER_USER, "-A", "trust", "-E", "UTF8", "--locale=C.UTF-8", "--no-sync")
        settings = f"-k {folder} {_NO_NETWORK} {'' if durable else _CARELESS}"
        call("pg_ctl", "start", "-w", "-l", str(log), "-o", settings)
        try:
            yield Cluster(Path(folder), run, programs)
        finally:
            call("pg_ctl", "stop", "-w", "-m", "immediate")
