"""Whether what a command finds can be written is seen before it starts."""

from pathlib import Path

import pytest

from captra.outputs import OutputError, check_folder, check_writable


def test_folders_are_made_and_files_stay_as_they_are(tmp_path: Path) -> None:
    known, new = tmp_path / "known.json", tmp_path / "a" / "b" / "new.json"
    known.write_text("of last week")
    check_writable(known, new, None)
    assert known.read_text() == "of last week"
    assert new.parent.is_dir()
    assert not new.exists()
    check_folder(tmp_path / "c" / "d")
    check_folder(None)
    assert (tmp_path / "c" / "d").is_dir()


def test_files_that_cannot_be_written_are_named(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(OutputError, match=r"cannot write .* \(Is a directory\): name a file that can be written"):
        check_writable(tmp_path)
    nowhere = r"cannot make the folder .*file \(.*name one that can be written"
    with pytest.raises(OutputError, match=nowhere):
        check_folder(tmp_path / "file")
    with pytest.raises(OutputError, match=nowhere):
        check_writable(tmp_path / "file" / "x.json")
