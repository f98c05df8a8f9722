"""Files that a command writes once its work is done."""

from pathlib import Path

from captra.errors import UserError


class OutputError(UserError):
    """A file cannot be written where it is to be."""


def check_writable(*files: Path | None) -> None:
    """Make the folders of files and see whether these can be written, before hours of work; None is no file.

    Raises:
        OutputError: one cannot be.
    """
    for file in files:
        if file is not None:
            _check(file)


def check_folder(folder: Path | None) -> None:
    """Make a folder that files will be written into; None is no folder.

    Raises:
        OutputError: it cannot be made.
    """
    if folder is not None:
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise OutputError(
                f"cannot make the folder {folder} ({error.strerror}): name one that can be written"
            ) from error


def _check(file: Path) -> None:
    check_folder(file.parent)
    known = file.exists()
    try:
        file.open("ab").close()  # what is there stays until there is something to replace it
    except OSError as error:
        raise OutputError(f"cannot write {file} ({error.strerror}): name a file that can be written") from error
    if not known:
        file.unlink()
