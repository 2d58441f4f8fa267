"""Taking turns: who writes into a catalog holds a row of it until the commit, and sees whether others wrote before.

A row that every writer changes is a lock that any SQL database has; it goes with the transaction, whatever becomes
of the process that held it.
"""

import sqlalchemy as sa

_TURNS = "turns"
_TAKE = sa.text(
    "UPDATE catalog_state SET value = CAST(CAST(value AS BIGINT) + 1 AS TEXT) WHERE key = :key RETURNING value"
)
_FIRST = sa.text("INSERT INTO catalog_state (key, value) VALUES (:key, '0') ON CONFLICT DO NOTHING")


def take_turn(connection: sa.Connection) -> int:
    """Wait until nobody else writes; this transaction is the only one that writes until it ends.

    Returns the number of the turn: where it is not the one after the last, somebody else wrote in between.
    """
    key = {"key": _TURNS}
    number = connection.execute(_TAKE, key).scalar()
    if number is None:
        connection.execute(_FIRST, key)
        number = connection.execute(_TAKE, key).scalar_one()
    return int(number)
