"""The exceptions, each with the exit code that the program has for it."""


class CandelaWarning(UserWarning):
    """A warning that the program would print to stderr, for example about an error in a scene that can be ignored."""


class Error(Exception):
    """Base class of all errors of Candela. Their texts are those of the program, with keywords instead of options."""

    exit_code = 70


class UsageError(Error, ValueError):
    """An option or an argument that is unknown, out of range or without effect."""

    exit_code = 1


class FileError(Error, OSError):
    """A file or an image that cannot be read or written, or that exceeds a limit."""

    exit_code = 2


class SceneError(FileError):
    """All errors of a scene: `diagnostics` lists (file, line, column, message), with 0 for an unknown line or column."""

    diagnostics = ()


class NoDeviceError(Error):
    """There is no usable Vulkan device, or none with this name."""

    exit_code = 4


class DeviceLostError(Error):
    """The device was lost, or its driver failed."""

    exit_code = 5


class DeviceHungError(DeviceLostError):
    """The device did not finish its work in time."""


class OutOfMemoryError(Error, MemoryError):
    """The work needs more memory than the machine or the device has."""

    exit_code = 6


class UndecidedError(Error):
    """A verdict that is not decided was used as a condition."""

    exit_code = 8


class InternalError(Error):
    """An error in Candela itself, or in a driver."""
