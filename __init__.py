"""MUYSC for QGIS: muon radiography and tomography of large structures."""


def classFactory(iface):  # noqa: N802 (QGIS asks for this name)
    """Return the plugin; `iface` is None when QGIS runs without a desktop."""
    from .muysc_qgis.plugin import MuyscPlugin

    return MuyscPlugin(iface)
