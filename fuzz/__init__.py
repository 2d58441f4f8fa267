"""Inputs that nobody wrote on purpose: what takes documents answers with a result or with a named error.

Every target is a module with ``check(data)``, which raises when an input is answered in another way, and ``seeds()``,
the files to start from. ``python -m fuzz`` lets atheris look for such inputs; the tests run the targets on seeds
changed by :mod:`fuzz.mutations`.
"""
