"""Networks from the bundles of a models folder, run by ONNX Runtime."""

import json
import logging
from collections.abc import Sequence
from pathlib import Path

from captra import depth_images, evidence, moments, observations, sampling
from captra.health import HealthMonitor
from captra.runtime.bundle import BundleError, find_bundles, load_manifest, verify
from captra.runtime.cores import available_cores
from captra.runtime.onnx_networks import OnnxNetworks
from captra.sampling import PROFILES
from captra.side_by_side import WhileCoresAreFree
from service.networks import Engine, LoadedOnce, Model, NoModelError
from service.rejections import CategoryWithoutModelError, ModelNotLoadableError, RejectedError
from service.warmup import warm_up

logger = logging.getLogger(__name__)


class BundleNetworks:
    """The provider of a running service: what is in the folder when it starts is what can be tracked."""

    def __init__(
        self,
        models_dir: Path,
        first_profile: str,
        provider: str,
        threads: int | None,
        preload: Sequence[str] = (),
    ) -> None:
        self._models_dir = models_dir
        self._first_profile = first_profile
        self._provider = provider
        self._threads = threads
        self._preload = preload
        self._side_by_side = WhileCoresAreFree(threads or available_cores())
        self._bundles = find_bundles(models_dir) if models_dir.is_dir() else {}
        self._errors: dict[str, str] = {}
        self._networks = LoadedOnce(self._load)

    def prepare(self) -> None:
        """Compile the kernels, look at every bundle, load those asked for, or else one, and run them once.

        Raises:
            NoModelError: not one bundle can be used.
        """
        for kernels in (sampling, observations, depth_images, moments, evidence):
            kernels.warm_up()
        self._check_files()
        for category in self._preload:
            self._try(category)
        if not self._preload:
            next(filter(self._try, self._bundles), None)
        if len(self._errors) == len(self._bundles):
            reasons = "; ".join(self._errors.values()) or "there is none"
            raise NoModelError(
                f"no model can be used in {self._models_dir} ({reasons}): put bundles there with captra export, "
                "or set CAPTRA_MODELS_DIR to the folder that holds them"
            )

    def _check_files(self) -> None:
        """Tell of damaged bundles before anybody asks for them."""
        for category, folder in self._bundles.items():
            try:
                verify(folder, load_manifest(folder))
            except BundleError as error:
                self._errors[category] = str(error)
                logger.error("%s", error, extra={"category": category})

    def _try(self, category: str) -> bool:
        try:
            self.get(category, self._first_profile)
        except RejectedError as rejection:
            logger.error("%s", rejection, extra={"category": category})
            return False
        return True

    def get(self, category: str, profile: str) -> Engine:
        """Networks of a category, loaded now unless they are already.

        Raises:
            CategoryWithoutModelError: there is no bundle.
            ModelNotLoadableError: there is one, but it cannot be loaded.
        """
        if category not in self._bundles:
            there = ", ".join(self._bundles) or "none"
            raise CategoryWithoutModelError(
                f"there is no model of {category} here: use a category that has one ({there}), "
                "or put a bundle of it into CAPTRA_MODELS_DIR and restart the service"
            )
        return engine_of(self._networks.get(category, profile))

    def models(self) -> Sequence[Model]:
        """Every bundle."""
        return [self._model(category, folder) for category, folder in self._bundles.items()]

    def _load(self, category: str, profile: str) -> OnnxNetworks:
        folder = self._bundles[category]
        try:
            networks = OnnxNetworks.load(folder, PROFILES[profile], self._provider, self._threads, self._side_by_side)
            if networks.category.name != category:
                raise BundleError(f"it is of {networks.category.name}: call its folder so")
            warm_up(engine_of(networks))
        except Exception as error:
            logger.exception("bundle cannot be loaded", extra={"category": category, "profile": profile})
            self._errors[category] = str(error)
            raise ModelNotLoadableError(f"the model of {category} in {folder} cannot be loaded: {error}") from error
        self._errors.pop(category, None)
        logger.info(
            "model loaded", extra={"category": category, "profile": profile, "provider": networks.provider.name}
        )
        return networks

    def _model(self, category: str, folder: Path) -> Model:
        loaded = self._networks.loaded(category)
        try:
            manifest = load_manifest(folder)
        except BundleError as error:
            return Model(category, "", self._provider, (), (), str(error), {})
        return Model(
            category=category,
            precision=manifest.precision,
            provider=next((networks.provider.name for networks in loaded.values()), self._provider),
            profiles=tuple(PROFILES),
            loaded=tuple(loaded),
            error=self._errors.get(category),
            manifest=json.loads(manifest.to_json()),
        )


def engine_of(networks: OnnxNetworks) -> Engine:
    """The networks with the confidence that was calibrated on them."""
    return Engine(networks, HealthMonitor.calibrated(networks.manifest.health))
