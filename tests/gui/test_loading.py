"""What is loaded when: nothing of the desktop headless, the dock when it is opened."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


def test_without_a_desktop_nothing_of_it_is_loaded(tmp_path):
    code = (
        "import importlib.util, sys\n"
        "from qgis.core import QgsApplication\n"
        f"application = QgsApplication([], False, {str(tmp_path)!r})\n"
        "application.initQgis()\n"
        "spec = importlib.util.spec_from_file_location(\n"
        f"    'plugin', {str(ROOT / '__init__.py')!r},\n"
        f"    submodule_search_locations=[{str(ROOT)!r}])\n"
        "package = sys.modules['plugin'] = importlib.util.module_from_spec(spec)\n"
        "spec.loader.exec_module(package)\n"
        "plugin = package.classFactory(None)\n"
        "plugin.initProcessing()\n"
        "print(*(name for name in sys.modules if name.startswith('plugin.muysc_qgis.gui')))\n"
        "plugin.unload()\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == []


def test_the_desktop_loads_the_dock_when_it_is_opened(gui, desktop):
    assert desktop.dock is None
    assert not desktop.action.isChecked()
    desktop.action.setChecked(True)
    assert desktop.dock.isVisible()
    desktop.dock.close()
    assert not desktop.action.isChecked()


def test_the_plugin_adds_and_removes_its_button(gui, iface, provider, monkeypatch):
    module = sys.modules[type(provider).__module__.split(".")[0]]
    plugin = module.classFactory(iface)
    # The provider is there already; there can be one of a name.
    monkeypatch.setattr(type(plugin), "initProcessing", lambda self: None)
    plugin.initGui()
    assert [action.text() for action in iface.menu] == ["Plan a muon telescope"]
    plugin.unload()
    assert iface.menu == []
