"""Messages of the library, as warnings and as records of logging."""
import logging
import warnings

from ._errors import CandelaWarning

_log = logging.getLogger("candela")


def publish(kind, text):
    """Warns of a problem or a warning; logs a note (INFO) or a detail (DEBUG)."""
    if kind in ("problem", "warning"):
        warnings.warn(text, CandelaWarning, stacklevel=2)
    else:
        _log.log(logging.INFO if kind == "note" else logging.DEBUG, text)
