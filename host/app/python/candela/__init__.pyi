"""Types of the module. Options are those of the command line, which docs/python.md explains; None omits one."""
import os
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Literal, SupportsIndex, TypedDict, final, overload

import numpy
import numpy.typing

__version__: str

_Path = str | bytes | os.PathLike[str] | os.PathLike[bytes]
_Flag = bool | numpy.bool_
_Count = SupportsIndex | float  #: a whole number; 4.0 is one
_Whole = Sequence[SupportsIndex] | numpy.typing.NDArray[numpy.integer[Any]]
_Pair = _Whole | str  #: width and height, as a pair or as "WxH"
_Crop = _Whole | str  #: left column, top row, width and height
_Duration = float | str  #: seconds, or with a unit: "90s", "1.5min", "2h"
_Progress = Callable[[float, int], object]  #: gets the fraction that is done and a number of samples
_Vector = Sequence[float] | numpy.typing.NDArray[Any]
_Integrator = Literal["path", "whitted", "ao", "normal", "albedo", "depth", "id", "cost"]
_Layer = Literal[
    "normal", "albedo", "depth", "position", "uv", "direct", "indirect", "emission", "variance", "samples", "moments",
    "crypto-object", "crypto-material",
]
_LayerChoice = _Layer | Literal["id", "material", "all"]  #: "id" is "crypto-object", and "material" "crypto-material"
_Floats = numpy.typing.NDArray[numpy.float32]

class _Material(TypedDict, total=False):
    base_colour: _Vector
    metallic: float
    roughness: float
    emission: _Vector
    ior: float
    specular: float
    specular_colour: _Vector
    transmission: float
    thickness: float
    attenuation_colour: _Vector
    attenuation_distance: float
    dispersion: float
    clearcoat: float
    clearcoat_roughness: float
    sheen_colour: _Vector
    sheen_roughness: float
    iridescence: float
    iridescence_ior: float
    iridescence_minimum: float
    iridescence_maximum: float
    conductor_ior: _Vector
    conductor_extinction: _Vector
    alpha: float
    alpha_cutoff: float
    double_sided: bool
    unlit: bool

class _Light(TypedDict, total=False):
    kind: Literal["point", "spot", "directional"]
    position: _Vector
    direction: _Vector
    intensity: _Vector
    inner: float
    outer: float

#: The keys "from", "at", "up", "angle", "resolution", "aperture", "focal" and "orthographic_height".
_Camera = dict[str, Any]

@final
class Scene:
    def __init__(
        self,
        vertices: numpy.typing.ArrayLike,
        faces: numpy.typing.ArrayLike,
        materials: Iterable[_Material] | None = ...,
        face_materials: numpy.typing.ArrayLike | None = None,
        *,
        normals: numpy.typing.ArrayLike | None = None,
        texcoords: numpy.typing.ArrayLike | None = None,
        colours: numpy.typing.ArrayLike | None = None,
        lights: Iterable[_Light] | None = ...,
        camera: _Camera | None = None,
        name: str = "scene",
        lenient: _Flag | None = None,
        allow_path: _Path | Sequence[_Path] | None = None,
        env: _Path | None = None,
        env_rotate: float | None = None,
        env_scale: float | None = None,
    ) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def hash(self) -> str: ...
    @property
    def report(self) -> dict[str, Any]: ...

@final
class Film:
    @property
    def image(self) -> _Floats: ...
    @property
    def variance(self) -> _Floats: ...
    @property
    def samples(self) -> numpy.typing.NDArray[numpy.uint32]: ...
    @property
    def alpha(self) -> _Floats | None: ...
    @property
    def layers(self) -> dict[str, _Floats]: ...
    def layer(self, name: _Layer, /) -> numpy.typing.NDArray[Any]: ...
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def hash(self) -> str: ...
    @property
    def interrupted(self) -> bool: ...
    @property
    def description(self) -> dict[str, Any]: ...
    @property
    def report(self) -> dict[str, Any] | None: ...
    def save(
        self,
        *files: _Path,
        checkpoint: _Path | None = None,
        tonemap: Literal["none", "srgb", "aces", "aces-hill", "agx", "pbr-neutral", "neutral"] | None = None,
        exposure: float | Literal["auto"] | None = None,
        denoise: _Flag | Literal["oidn"] | None = None,
        device: str | int | None = None,
        no_cache: _Flag | None = None,
    ) -> None: ...
    def denoise(
        self,
        *,
        device: str | int | None = None,
        hang_timeout: _Duration | None = None,
        no_cache: _Flag | None = None,
    ) -> _Floats: ...
    def _repr_png_(self) -> bytes: ...
    def __copy__(self) -> Film: ...
    def __deepcopy__(self, memo: dict[int, Any], /) -> Film: ...

@final
class Sequence:
    def __init__(
        self,
        file: _Path,
        /,
        *,
        lenient: _Flag | None = None,
        allow_path: _Path | Sequence[_Path] | None = None,
        define: str | Sequence[str] | None = None,
        env: _Path | None = None,
        env_rotate: float | None = None,
        env_scale: float | None = None,
        camera: str | int | None = None,
        time: float | None = None,
        animation: str | int | None = None,
        orbit: float | None = None,
        frames: range | str | None = None,
        fps: float | None = None,
        turntable: _Count | None = None,
        spp: _Count | None = None,
        seed: _Count | Literal["frame"] | None = None,
        size: _Pair | None = None,
        max_depth: _Count | None = None,
        rr_start: _Count | None = None,
        integrator: _Integrator | None = None,
        ao_distance: float | Literal["auto"] | None = None,
        nee: _Flag | None = None,
        lights: Literal["power", "tree", "auto"] | None = None,
        sampler: Literal["independent", "stratified", "sobol"] | None = None,
        filter: Literal["box", "tent", "gaussian"] | str | None = None,
        lens: Literal["disc", "square"] | None = None,
        pixel_origin: Literal["centre", "corner"] | None = None,
        light_size: float | None = None,
        clamp_indirect: float | Literal["off"] | None = None,
        background: Literal["env", "colour", "none"] | None = None,
        film_scale: int | Literal["auto"] | None = None,
        one_sided: _Flag | None = None,
        crop: _Crop | None = None,
        device: str | int | None = None,
        accel: Literal["none", "grid", "bvh"] | None = None,
        bvh_split: Literal["sah", "midpoint"] | None = None,
        bvh_quality: Literal["fast", "default", "high"] | None = None,
        layout: Literal["auto", "bvh2", "cwbvh"] | None = None,
        loads: Literal["auto", "texel", "storage"] | None = None,
        grid_density: float | None = None,
        kernel: Literal["auto", "megakernel", "wavefront"] | None = None,
        workgroup: _Pair | None = None,
        tile: _Pair | None = None,
        segments_per_dispatch: int | Literal["auto"] | None = None,
        hang_timeout: _Duration | None = None,
        untuned: _Flag | None = None,
        no_cache: _Flag | None = None,
        threads: _Count | None = None,
        aovs: Sequence[_LayerChoice] | str | None = None,
        aov_through_specular: _Flag | None = None,
        denoise: _Flag | Literal["oidn"] | None = None,
        fallback: Literal["none", "cpu"] | None = None,
        noise_threshold: float | Literal["off"] | None = None,
    ) -> None: ...
    def render(self, frame: SupportsIndex, /, *, progress: _Progress | None = None) -> Film: ...
    @property
    def frames(self) -> range: ...

@final
class Session:
    def __init__(
        self,
        scene: Scene,
        /,
        *,
        spp: _Count | None = None,
        seed: _Count | None = None,
        size: _Pair | None = None,
        max_depth: _Count | None = None,
        rr_start: _Count | None = None,
        integrator: _Integrator | None = None,
        ao_distance: float | Literal["auto"] | None = None,
        nee: _Flag | None = None,
        lights: Literal["power", "tree", "auto"] | None = None,
        sampler: Literal["independent", "stratified", "sobol"] | None = None,
        filter: Literal["box", "tent", "gaussian"] | str | None = None,
        lens: Literal["disc", "square"] | None = None,
        pixel_origin: Literal["centre", "corner"] | None = None,
        light_size: float | None = None,
        clamp_indirect: float | Literal["off"] | None = None,
        background: Literal["env", "colour", "none"] | None = None,
        film_scale: int | Literal["auto"] | None = None,
        one_sided: _Flag | None = None,
        crop: _Crop | None = None,
        device: str | int | None = None,
        accel: Literal["none", "grid", "bvh"] | None = None,
        bvh_split: Literal["sah", "midpoint"] | None = None,
        bvh_quality: Literal["fast", "default", "high"] | None = None,
        layout: Literal["auto", "bvh2", "cwbvh"] | None = None,
        loads: Literal["auto", "texel", "storage"] | None = None,
        grid_density: float | None = None,
        kernel: Literal["auto", "megakernel", "wavefront"] | None = None,
        workgroup: _Pair | None = None,
        tile: _Pair | None = None,
        segments_per_dispatch: int | Literal["auto"] | None = None,
        hang_timeout: _Duration | None = None,
        untuned: _Flag | None = None,
        no_cache: _Flag | None = None,
        threads: _Count | None = None,
        aovs: Sequence[_LayerChoice] | str | None = None,
        aov_through_specular: _Flag | None = None,
        denoise: _Flag | Literal["oidn"] | None = None,
    ) -> None: ...
    def advance(self, samples: SupportsIndex | range | None = None, *, progress: _Progress | None = None) -> None: ...
    def reset(self, seed: SupportsIndex) -> None: ...
    def close(self) -> None: ...
    @property
    def film(self) -> Film: ...
    @property
    def done(self) -> int: ...
    @property
    def spp(self) -> int: ...
    def __enter__(self) -> Session: ...
    def __exit__(self, *exception: object) -> None: ...

@final
class Verdict:
    @property
    def agrees(self) -> bool: ...
    @property
    def verdict(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def report(self) -> dict[str, Any]: ...
    def __bool__(self) -> bool: ...

@final
class Comparison:
    @property
    def agrees(self) -> bool | None: ...
    @property
    def verdict(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def report(self) -> dict[str, Any]: ...
    def __bool__(self) -> bool: ...

@final
class Explanation:
    @property
    def agrees(self) -> bool: ...
    @property
    def verdict(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def report(self) -> dict[str, Any]: ...
    def __bool__(self) -> bool: ...

def devices() -> list[dict[str, Any]]: ...
def load(
    file: _Path,
    /,
    *,
    lenient: _Flag | None = None,
    allow_path: _Path | Sequence[_Path] | None = None,
    define: str | Sequence[str] | None = None,
    env: _Path | None = None,
    env_rotate: float | None = None,
    env_scale: float | None = None,
    camera: str | int | None = None,
    time: float | None = None,
    animation: str | int | None = None,
    orbit: float | None = None,
) -> Scene: ...
def render(
    scene: Scene,
    /,
    *,
    progress: _Progress | None = None,
    spp: _Count | None = None,
    seed: _Count | None = None,
    size: _Pair | None = None,
    max_depth: _Count | None = None,
    rr_start: _Count | None = None,
    integrator: _Integrator | None = None,
    ao_distance: float | Literal["auto"] | None = None,
    nee: _Flag | None = None,
    lights: Literal["power", "tree", "auto"] | None = None,
    sampler: Literal["independent", "stratified", "sobol"] | None = None,
    filter: Literal["box", "tent", "gaussian"] | str | None = None,
    lens: Literal["disc", "square"] | None = None,
    pixel_origin: Literal["centre", "corner"] | None = None,
    light_size: float | None = None,
    clamp_indirect: float | Literal["off"] | None = None,
    background: Literal["env", "colour", "none"] | None = None,
    film_scale: int | Literal["auto"] | None = None,
    one_sided: _Flag | None = None,
    device: str | int | None = None,
    accel: Literal["none", "grid", "bvh"] | None = None,
    bvh_split: Literal["sah", "midpoint"] | None = None,
    bvh_quality: Literal["fast", "default", "high"] | None = None,
    layout: Literal["auto", "bvh2", "cwbvh"] | None = None,
    loads: Literal["auto", "texel", "storage"] | None = None,
    grid_density: float | None = None,
    kernel: Literal["auto", "megakernel", "wavefront"] | None = None,
    workgroup: _Pair | None = None,
    tile: _Pair | None = None,
    segments_per_dispatch: int | Literal["auto"] | None = None,
    hang_timeout: _Duration | None = None,
    fallback: Literal["none", "cpu"] | None = None,
    untuned: _Flag | None = None,
    no_cache: _Flag | None = None,
    threads: _Count | None = None,
    checkpoint: _Path | None = None,
    checkpoint_every: _Duration | None = None,
    resume: _Path | None = None,
    resume_anyway: _Flag | None = None,
    time_limit: _Duration | None = None,
    samples: range | str | None = None,
    crop: _Crop | None = None,
    aovs: Sequence[_LayerChoice] | str | None = None,
    aov_through_specular: _Flag | None = None,
    noise_threshold: float | Literal["off"] | None = None,
    denoise: _Flag | Literal["oidn"] | None = None,
) -> Film: ...
def open_film(file: _Path, /) -> Film: ...
def merge(files: Iterable[_Path], /, *, mixed_devices: _Flag | None = None, partial: _Flag | None = None) -> Film: ...
def verify(
    scene: Scene,
    /,
    *,
    progress: _Progress | None = None,
    seed: _Count | None = None,
    size: _Pair | None = None,
    max_depth: _Count | None = None,
    rr_start: _Count | None = None,
    integrator: _Integrator | None = None,
    ao_distance: float | Literal["auto"] | None = None,
    nee: _Flag | None = None,
    lights: Literal["power", "tree", "auto"] | None = None,
    sampler: Literal["independent", "stratified", "sobol"] | None = None,
    filter: Literal["box", "tent", "gaussian"] | str | None = None,
    lens: Literal["disc", "square"] | None = None,
    pixel_origin: Literal["centre", "corner"] | None = None,
    light_size: float | None = None,
    film_scale: int | Literal["auto"] | None = None,
    one_sided: _Flag | None = None,
    device: str | int | None = None,
    layout: Literal["auto", "bvh2", "cwbvh"] | None = None,
    loads: Literal["auto", "texel", "storage"] | None = None,
    grid_density: float | None = None,
    kernel: Literal["auto", "megakernel", "wavefront"] | None = None,
    workgroup: _Pair | None = None,
    tile: _Pair | None = None,
    segments_per_dispatch: int | Literal["auto"] | None = None,
    hang_timeout: _Duration | None = None,
    untuned: _Flag | None = None,
    no_cache: _Flag | None = None,
    threads: _Count | None = None,
    alpha: float | str | None = None,
    bias: float | str | None = None,
    test: Literal["paired", "independent"] | None = None,
    time_limit: _Duration | None = None,
) -> Verdict: ...
def explain(
    scene: Scene,
    /,
    *,
    progress: _Progress | None = None,
    spp: _Count | None = None,
    seed: _Count | None = None,
    size: _Pair | None = None,
    max_depth: _Count | None = None,
    rr_start: _Count | None = None,
    integrator: _Integrator | None = None,
    ao_distance: float | Literal["auto"] | None = None,
    nee: _Flag | None = None,
    lights: Literal["power", "tree", "auto"] | None = None,
    sampler: Literal["independent", "stratified", "sobol"] | None = None,
    filter: Literal["box", "tent", "gaussian"] | str | None = None,
    lens: Literal["disc", "square"] | None = None,
    pixel_origin: Literal["centre", "corner"] | None = None,
    light_size: float | None = None,
    clamp_indirect: float | Literal["off"] | None = None,
    background: Literal["env", "colour", "none"] | None = None,
    film_scale: int | Literal["auto"] | None = None,
    one_sided: _Flag | None = None,
    device: str | int | None = None,
    accel: Literal["none", "grid", "bvh"] | None = None,
    bvh_split: Literal["sah", "midpoint"] | None = None,
    bvh_quality: Literal["fast", "default", "high"] | None = None,
    layout: Literal["auto", "bvh2", "cwbvh"] | None = None,
    loads: Literal["auto", "texel", "storage"] | None = None,
    grid_density: float | None = None,
    kernel: Literal["auto", "megakernel", "wavefront"] | None = None,
    workgroup: _Pair | None = None,
    tile: _Pair | None = None,
    segments_per_dispatch: int | Literal["auto"] | None = None,
    hang_timeout: _Duration | None = None,
    untuned: _Flag | None = None,
    no_cache: _Flag | None = None,
    threads: _Count | None = None,
    pixel: _Whole | str | None = None,
    sample: _Count | None = None,
) -> Explanation: ...
@overload
def compare(
    scene: Scene,
    /,
    *,
    progress: _Progress | None = None,
    spp: _Count | None = None,
    seed: _Count | None = None,
    size: _Pair | None = None,
    max_depth: _Count | None = None,
    rr_start: _Count | None = None,
    integrator: _Integrator | None = None,
    ao_distance: float | Literal["auto"] | None = None,
    nee: _Flag | None = None,
    lights: Literal["power", "tree", "auto"] | None = None,
    sampler: Literal["independent", "stratified", "sobol"] | None = None,
    filter: Literal["box", "tent", "gaussian"] | str | None = None,
    lens: Literal["disc", "square"] | None = None,
    pixel_origin: Literal["centre", "corner"] | None = None,
    light_size: float | None = None,
    clamp_indirect: float | Literal["off"] | None = None,
    background: Literal["env", "colour", "none"] | None = None,
    film_scale: int | Literal["auto"] | None = None,
    one_sided: _Flag | None = None,
    device: str | int | None = None,
    accel: Literal["none", "grid", "bvh"] | None = None,
    bvh_split: Literal["sah", "midpoint"] | None = None,
    bvh_quality: Literal["fast", "default", "high"] | None = None,
    layout: Literal["auto", "bvh2", "cwbvh"] | None = None,
    loads: Literal["auto", "texel", "storage"] | None = None,
    grid_density: float | None = None,
    kernel: Literal["auto", "megakernel", "wavefront"] | None = None,
    workgroup: _Pair | None = None,
    tile: _Pair | None = None,
    segments_per_dispatch: int | Literal["auto"] | None = None,
    hang_timeout: _Duration | None = None,
    untuned: _Flag | None = None,
    no_cache: _Flag | None = None,
    threads: _Count | None = None,
    alpha: float | str | None = None,
    bias: float | str | None = None,
) -> Comparison: ...
@overload
def compare(
    a: Film | _Path | numpy.typing.NDArray[Any],
    b: Film | _Path | numpy.typing.NDArray[Any],
    /,
    *,
    alpha: float | str | None = None,
    bias: float | str | None = None,
    tolerance: float | None = None,
    channels: Sequence[str] | str | None = None,
    tonemap: str | None = None,
    exposure: float | Literal["auto"] | None = None,
) -> Comparison: ...

class CandelaWarning(UserWarning): ...

class Error(Exception):
    exit_code: int

class UsageError(Error, ValueError): ...
class FileError(Error, OSError): ...

class SceneError(FileError):
    diagnostics: Sequence[tuple[str, int, int, str]]

class NoDeviceError(Error): ...
class DeviceLostError(Error): ...
class DeviceHungError(DeviceLostError): ...
class OutOfMemoryError(Error, MemoryError): ...
class UndecidedError(Error): ...
class InternalError(Error): ...
