"""Take the pictures of the user guide: the real QGIS, on a screen that nobody sees.

Needs QGIS and Xvfb; run as ``make screenshots``, which writes to docs/images. What QGIS does
there stands in ``guide_scenes.py``.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images"
SCENES = Path(__file__).parent / "guide_scenes.py"
#: Package name of the plugin, which is its folder's.
PLUGIN = "muysc"
#: Pictures by the language that QGIS is started in.
PICTURES = {
    "en": ("guide_desktop", "guide_section", "guide_sites", "guide_toolbox", "guide_dialog",
           "guide_muogram", "guide_draped", "guide_model"),
    "es": ("guide_spanish",),
}  # fmt: skip
SECONDS = 240


@contextmanager
def screen() -> Iterator[str]:
    """Run a screen without a monitor; yield its name."""
    reading, writing = os.pipe()
    server = subprocess.Popen(  # noqa: S603
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1600x1000x24", "-nolisten", "tcp"],  # noqa: S607
        pass_fds=[writing],
        stderr=subprocess.DEVNULL,
    )
    os.close(writing)
    try:
        with os.fdopen(reading) as pipe:
            number = pipe.readline().strip()
        if not number:
            sys.exit("Xvfb did not start.")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()


def take(language: str, display: str, home: Path) -> None:
    """Start QGIS in a profile of its own and let it take the pictures of a language."""
    settings = home / "profiles" / "default" / "QGIS" / "QGIS3.ini"
    settings.parent.mkdir(parents=True)
    settings.write_text(
        f"[PythonPlugins]\n{PLUGIN}=true\n\n[app]\ncheckVersion=false\n\n"
        f"[locale]\nuserLocale={language}\noverrideFlag=true\n",
        encoding="utf-8",
    )
    plugins = home / "plugins"
    plugins.mkdir()
    (plugins / PLUGIN).symlink_to(ROOT)
    subprocess.run(  # noqa: S603
        ["qgis", "--profiles-path", home, "--nologo", "--noversioncheck", "--code", SCENES],  # noqa: S607
        env={
            **os.environ,
            "HOME": str(home),
            "XDG_RUNTIME_DIR": str(home),
            "QGIS_PLUGINPATH": str(plugins),
            "MUYSC_TOOLS": str(SCENES.parent),
            "MUYSC_IMAGES": str(IMAGES),
            "MUYSC_PICTURES": " ".join(PICTURES[language]),
            "DISPLAY": display,
            "QT_QPA_PLATFORM": "xcb",
            "LC_ALL": "C.UTF-8",
            "PYTHONWARNINGS": "ignore",
        },
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        timeout=SECONDS,
        check=True,
    )
    for name in PICTURES[language]:
        if not (IMAGES / f"{name}.png").is_file():
            sys.exit(f"The picture {name} was not taken.")
        print(f"Wrote docs/images/{name}.png.")


def main() -> None:
    """Take every picture anew."""
    for names in PICTURES.values():
        for name in names:
            (IMAGES / f"{name}.png").unlink(missing_ok=True)
    with screen() as display:
        for language in PICTURES:
            with tempfile.TemporaryDirectory(prefix="muysc-pictures-") as home:
                take(language, display, Path(home))


if __name__ == "__main__":
    main()
