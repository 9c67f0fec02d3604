"""The models as one-line commands."""


def test_a_volcano_survey_from_the_command_line(qgis_process, data_folder, tmp_path):
    files = {
        "radiography:THICKNESS": tmp_path / "thickness.tif",
        "radiography:FLUX": tmp_path / "flux.tif",
        "radiography:FIELD_OF_VIEW": tmp_path / "field_of_view.gpkg",
        "thickness:OUTPUT": tmp_path / "thickness_on_the_map.tif",
        "flux:OUTPUT": tmp_path / "flux_on_the_map.tif",
    }
    done = qgis_process.run(
        "volcanosurvey",
        {
            "DEM": data_folder / "vesuvius_srtmgl1.tif",
            "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
            "TARGET": "14.424745,40.823729 [EPSG:4326]",
            "AZIMUTH_PIXELS": 21,
            "ELEVATION_PIXELS": 11,
            **files,
        },
    )
    assert done.returncode == 0, done.stdout + done.stderr
    for name, path in files.items():
        assert path.is_file()
        assert f"{name}:\t{path}" in done.stdout


def test_the_help_of_a_model_lists_inputs_and_outputs(qgis_process):
    done = qgis_process("help", "muysc:exposureplan")
    assert done.returncode == 0, done.stderr
    for name in ("DETECTOR", "PRESET", "DAYS", "telescope:COUNTS", "exposure:OUTPUT"):
        assert name in done.stdout
