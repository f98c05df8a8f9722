"""Who made an object of a library: licences that ask for it want the author named wherever the object was used."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from captra.errors import UserError

AUTHOR_IN_NOTES = re.compile(r"(?:^|;)\s*author:?\s+([^;]+)", re.IGNORECASE)
IN_BRACKETS = re.compile(r"(?P<licence>.*?)\s*\((?P<author>.*)\)\s*")
ASKS_FOR_ITS_AUTHOR = re.compile(r"CC[ -]BY\b", re.IGNORECASE)


class UnnamedAuthorError(UserError, ValueError):
    """A library does not say who made an object whose licence asks for it."""


@dataclass(frozen=True)
class Credit:
    """What is said of one object; as text `licence (author)`."""

    licence: str
    """Without the author."""
    author: str
    """Empty where nobody is known."""

    @staticmethod
    def of(entry: Mapping[str, Any]) -> "Credit":
        """What an entry of INDEX.json says: `author`, else `author NAME` in its notes, else brackets of its licence."""
        credit, noted = Credit.read(entry["licence"]), AUTHOR_IN_NOTES.search(entry.get("notes", ""))
        author = entry.get("author") or (noted.group(1).strip() if noted else credit.author)
        return Credit(credit.licence, author)

    @staticmethod
    def read(text: str) -> "Credit":
        """The inverse of `str`."""
        named = IN_BRACKETS.fullmatch(text)
        return Credit(named["licence"], named["author"]) if named else Credit(text, "")

    def checked(self, name: str) -> "Credit":
        """The same, if it is enough to train on the object `name`.

        Raises:
            UnnamedAuthorError: the licence is a CC BY, and no author is known.
        """
        if ASKS_FOR_ITS_AUTHOR.match(self.licence) and not self.author:
            raise UnnamedAuthorError(
                f"{name} is {self.licence}, which asks for its author, and INDEX.json names none: "
                'add "author": "NAME" to its entry'
            )
        return self

    def __str__(self) -> str:
        """As it is kept beside the views."""
        return f"{self.licence} ({self.author})" if self.author else self.licence
