from pathlib import Path

import pytest
import torch

from tests.made_up import write_bundle

torch.set_num_threads(1)


@pytest.fixture(scope="session")
def mug_bundle(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_bundle("mug", tmp_path_factory.mktemp("models") / "mug")
