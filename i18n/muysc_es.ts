<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
  <context>
    <name>MUYSC</name>
    <message>
      <source>Density from a measured muogram</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Radiography</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Computes the mean density along each ray from what a telescope measured, with its error: the inverse of &lt;i&gt;Muon radiography&lt;/i&gt;, with the same physics.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What you need.&lt;/b&gt; A muogram of rock thickness (from &lt;i&gt;Muon radiography&lt;/i&gt;) and, on the same directions, one of: muon &lt;b&gt;counts&lt;/b&gt; with exposure and acceptance; counts with those of the same telescope in the &lt;b&gt;open sky&lt;/b&gt;, so that acceptance and efficiency drop out, wherever in the sky it pointed; a measured &lt;b&gt;flux&lt;/b&gt;; or a measured &lt;b&gt;transmission&lt;/b&gt;. &lt;i&gt;Import muogram&lt;/i&gt; reads all of them from text.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Counts in telescope angles work too, with a thickness in telescope angles as &lt;i&gt;Expected counts in a telescope&lt;/i&gt; writes it, and the acceptance of every pixel or a run in the open sky. Rasters, panel and report are then in telescope angles.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; The opacity is found for which the flux model, attenuated in rock, gives the flux measured; divided by the thickness it is the density. Density contains the error of counting and, if given, the uncertainty of the flux model. From 20 counts on the error is σ/ρ = N&lt;sup&gt;−1/2&lt;/sup&gt; divided by the slope of the flux; below, it follows from exact confidence intervals, whose ends (&lt;i&gt;density lower&lt;/i&gt; and &lt;i&gt;upper&lt;/i&gt;) are then not symmetric.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Merging.&lt;/b&gt; With a minimum of counts, neighbouring pixels are merged into rectangles that reach it; each has the one density that explains its counts, with the thickness of every pixel as it is.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Flags.&lt;/b&gt; 0 measured; 1 no rock, no data; 2 no muon was counted: the density is a lower limit at the confidence chosen and has no error; 3 as bright as the open sky: density 0; 4 measurement or thickness missing; 5 no density explains the flux, or the ray is at or below the horizon; 6 too little rock to stop any of the muons that count, no data.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Mean density.&lt;/b&gt; For counts, the one density that lets through as many muons as were counted in all, pixels without a muon included; for flux and transmission, the mean weighted by the errors. The uncertainty of the flux model does not average out.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Smallest and largest density&lt;/b&gt; are the spread over the flux models that hold for each ray's energy and zenith angle.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Thickness muogram</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muogram of rock thickness in m, seen from the same place on the same directions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muon counts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muogram of muons counted in each pixel, whole numbers. Give exactly one of counts, flux and transmission.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured flux</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muogram of measured flux in cm⁻² sr⁻¹ day⁻¹.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured transmission</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muogram of measured transmission, flux over that of the open sky in the same direction, from 0 to 1.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Errors of flux or transmission</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muogram of the standard errors of a measured flux or transmission, as the import writes it. Counts need none.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposure (days, empty: as the counts say)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the days of counting, above 0. Empty takes DAYS from the counts' metadata.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Acceptance of a pixel (cm² sr, empty: as the counts say)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the acceptance of one pixel in cm² sr, above 0, detection efficiency included. Empty takes ACCEPTANCE from the counts' metadata. Not used with an open-sky run.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Acceptances of the pixels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Raster of the acceptance of every pixel in cm² sr, in place of one for all, such as Telescope parameters writes it for counts in telescope angles.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Counts in the open sky</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muogram of muons that the same telescope pixels counted in the open sky. Acceptance and efficiency then drop out. Its elevations say where the telescope pointed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposure in the open sky (days, empty: as its counts say)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the days of counting in the open sky, above 0. Empty takes DAYS from the metadata of the counts in the open sky.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Merge pixels up to (counts, 0: no merging)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the counts that each region of merged pixels must reach, 0 or more. Neighbouring pixels then share one density. 20 and more make the errors symmetric.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Uncertainty of the flux model (%)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the relative uncertainty of the flux in %, from 0 to below 100. It is the same for all pixels and does not average out. The models differ by 10 % to 15 % behind rock.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Confidence of lower limits (%)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the one-sided confidence in % of the lower limit on density in pixels without a muon, above 50 and below 100.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Detector elevation (m, empty: the muogram's)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the altitude of the detector in m, −1000 to 10000, for the altitude correction. Empty takes what the muograms say.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Material</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rock or other matter, whose stopping power slows the muons.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muon flux model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Parametrised spectrum of the muons at sea level. gaisser-tang and guan hold for all energies and zenith angles; gaisser above 100/cos θ GeV and within 70° of the zenith; bugaev near the vertical; reyna-bugaev and reyna-hebbeker stretch vertical spectra to inclined muons.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Parameters of the Gaisser formula</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Constants of the models gaisser and gaisser-tang; the other models do not use them.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Energy loss</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>csda: range table of the material (recommended). lesparre: polynomial for standard rock, up to 1 TeV. paper: energy over stopping power in place of the range, as in the first MUYSC; without answer beyond about 613 m of rock.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct for straggling</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whether to correct the flux for the fluctuations of the energy loss, which let more muons through thick rock than the mean loss does: 1.5 % at 1 km water equivalent, 11 % at 3 km.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct for altitude</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whether the flux grows with the altitude of the detector. Made for momenta above 10 GeV/c and altitudes below 1 km; beyond that a warning is given.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Detection threshold (GeV)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the kinetic energy in GeV that a muon needs behind the rock to be detected, from 0 to below 100000. With 0 the open sky starts at 1 GeV/c.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Opacity (g/cm²)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Thickness times density, the mass per area that a muon has to cross. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean density (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean density along each ray; a lower limit where no muon was counted. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Error of the mean density (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard error of the density, half of its interval. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lower end of the mean density (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lower end of the interval of one standard deviation. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Upper end of the mean density (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Upper end of the interval of one standard deviation. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smallest mean density (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smallest density over the flux models that hold for the ray. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest mean density (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest density over the flux models that hold for the ray. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Flags of the mean density</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>0 measured, 1 no rock, 2 lower limit, 3 as bright as the open sky, 4 not measured, 5 no density explains the flux, 6 too little rock to dim it. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Panel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of density and its error side by side, with contours, skyline and target.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One HTML file with panels, map, parameters, numbers, every warning and how to cite.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Part of it from counting (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Median density (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels with rock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels with a density</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels with a lower limit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels with rock as bright as the open sky</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels that cannot be known</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Regions with a density of their own</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Download SRTM topography</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Terrain</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Makes the elevation model of an extent from public tiles of one degree: heights in m, in longitude and latitude, cell for cell as the tiles have them.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;The extent must hold the detector, the target and all rock behind it; a &lt;b&gt;margin&lt;/b&gt; widens it. Tiles come from the &lt;b&gt;source&lt;/b&gt;: &lt;i&gt;srtm&lt;/i&gt; (radar heights of 2000, 56° south to 60° north), &lt;i&gt;copernicus&lt;/i&gt; (GLO-30, 2011 to 2015, the surface with trees and buildings), or an address of your own. The log says how to name the source, and the raster keeps it.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Every tile is checked and kept in a folder, so that a run that was stopped goes on where it was and the next one needs no network. What comes is limited in number and size. The proxy, timeout and authentications of QGIS count.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;A tile that the server does not have is taken as sea level, and the log says so. &lt;b&gt;Cells without a height&lt;/b&gt; have no data, are counted, and are filled from their neighbours on request. The default source holds the depths of the sea floor too.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;One arc second, about 30 m, smooths crater rims by tens of metres.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Extent</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Part of the map, in any coordinate reference system: detector, target and all rock behind it. As text: xmin,xmax,ymin,ymax [EPSG:code]; without a code and a project longitudes and latitudes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Margin (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the width of the strip added around the extent in m, 0 to 100000.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Source of the tiles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>srtm: public Terrain Tiles, one arc second. copernicus: Copernicus GLO-30, one arc second, surface with trees and buildings. Or the address of tiles on https:// or file://, such as https://server/{latitude}/{tile}.hgt.gz, where {tile} stands for N40E014, {latitude} for N40 and {longitude} for E014; plain, gzipped and zipped .hgt and GeoTIFF. The setting muysc/srtm_source changes the default.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fill cells without a height</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whether cells without a height take that of their neighbours, weighted by the inverse of the distance.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>How far to look for heights (cells)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the distance at which voids are still filled in cells, a whole number from 1 to 1000; one cell is about 30 m.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest number of tiles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of tiles of one degree that may be downloaded, a whole number from 1 to 200. One has about 10 MB from srtm and 40 MB from copernicus.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Authentication</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Authentication configuration of QGIS, for servers that ask for a login.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Timeout (s, empty: that of QGIS)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the seconds without a byte after which an attempt ends, 0.1 to 600.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Further attempts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of further attempts after a timeout or a fault of the server, a whole number from 0 to 10; the pauses between them grow.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder of kept tiles (empty: in the profile)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder where tiles are kept and looked for; several runs may share it. Empty: cache/muysc in the profile of QGIS.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Elevation model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>GeoTIFF of heights in m in longitude and latitude (EPSG:4326), cell for cell as in the tiles; cells without a height have no data.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tiles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tiles from the cache</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tiles taken as sea level</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cells without a height</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cells that were filled</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Drape muogram on the terrain</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Puts a muogram back on the map: each cell of the elevation model that the detector sees carries the muogram's value in that direction, on the grid and in the coordinate reference system of the elevation model.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;The &lt;b&gt;near&lt;/b&gt; side is the rock face towards the detector, where rays enter the first rock; the &lt;b&gt;far&lt;/b&gt; side is where they leave the last. Cells that are hidden or outside the field of view have no data.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;The muogram says itself where its detector stands. The elevation model must contain the detector; it should be the one the muogram was made from, or a better one of the same place.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muogram</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muogram of any quantity, or raster of expected counts in telescope angles; it says itself where its detector stands.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Elevation model (DEM)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Raster of terrain heights, in any coordinate reference system. It must hold the detector, the target and all rock behind it. Cells without data count as unknown.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Band of the heights</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of the raster band that holds the heights, from 1.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Unit of the heights</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>auto takes the unit that the raster states, and metres where it states none.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Side of the rock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>near: the face towards the detector, where rays enter the first rock. far: the face away from it, where rays leave the last rock.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Draped muogram</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>GeoTIFF on the grid and in the coordinate reference system of the DEM; cells that the detector does not see have no data.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cells with a value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Expected counts in a telescope</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Telescope</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Computes how many muons a telescope counts behind a mountain along each of its trajectories, how precise the counts are, which density contrasts they show, and how many days that takes.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose an elevation model, click where the telescope stands and what it points at, choose the telescope and the days of counting, and run. Azimuth, elevation and roll of the telescope can be given too.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; The flux is that of &lt;i&gt;Muon radiography&lt;/i&gt;. Its mean over all directions that belong to a trajectory, rock and sky at the skyline alike, times the acceptance and the days gives the counts. The smallest visible contrast is the decrease of the mean density along the whole path whose counts chance would reach with the probability of the significance given; the days for a contrast follow from the same exact Poisson law, or from the feasibility formula of Lesparre et al. (2010).&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does not know&lt;/b&gt; has no data, never 0, and is counted in the log by cause: trajectories that look, in part, at or below the horizon, or along which the rock is unknown.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;The rasters&lt;/b&gt; have the tangent of the angle from the boresight as axes, the telescope's right as x and its up as y; boresight and roll in their metadata lead to azimuth and elevation, and the table lists them.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Merging&lt;/b&gt; takes an odd number of trajectories together across and up: less detail in less time.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Detector</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where the telescope stands, on the DEM. As text: x,y [EPSG:code]; without a code the point is in the project's CRS, or the DEM's where there is no project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Detector height above ground (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the height of the telescope above the ground in m, −10000 to 10000; negative in a tunnel or borehole.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What the telescope points at, on the DEM: the middle of the field of view.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Target height above ground (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the height of the aiming point above the ground in m, −10000 to 10000; negative inside the mountain.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A telescope that was built, or custom for the numbers below. A preset wins over numbers, and the log says which were not used. mute: 30 × 30 bars of 4 cm, 250 cm; gibert2010: 32 × 32 bars of 5 cm, 100 cm; carbone2014: 16 × 16 bars of 5 cm, 170 cm; lopresti2020: 99 × 99 bars of 1 cm, 97 cm; lesparre2012: 16 × 16 bars of 5 cm, 115 cm; lesparre2010: 16 × 16 bars of 5 cm, 80 cm; uchida2009: 12 × 12 bars of 7 cm, 100 cm; muraves: 60 × 60 bars of 3.4 cm, 200 cm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Bars across (custom telescope)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of bars side by side, 1 to 1000.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Bars up (empty: as many as across)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of bars one above another, 1 to 1000.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Width of a bar (cm, custom telescope)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the width of a bar in cm, above 0: the side of a pixel.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Separation of the planes (cm, custom telescope)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the distance between the front and the back plane in cm, above 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Planes (empty: 2)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of planes, 2 to 20, the outer two included. Those in between change neither directions nor acceptance: a straight track through the outer ones crosses them too. They are drawn.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Acceptance formula</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>exact: full integral over two pixels. paper: pixel area squared over the squared distance, as MUYSC was published; it leaves out the obliquity of the planes and is too high at large angles, by 7 % to 47 % in total.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Boresight azimuth (°, empty: towards the target)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the azimuth of the telescope's axis in degrees clockwise from true north, −360 to 360. Empty points at the target.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Boresight elevation (°, empty: towards the target)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the elevation of the telescope's axis above the horizontal in degrees, −90 to 90. Empty points at the target.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Roll (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the angle in degrees, −360 to 360, by which the telescope is turned clockwise about its axis, seen looking along it. With 0 its bars are level.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Days of counting (days)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the time of counting in days, above 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muons along a trajectory</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of muons wanted along each trajectory, above 0, for the exposure time. 10 muons give the flux to about 32 %, 100 to 10 %.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Significance (standard deviations)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the significance in standard deviations with which a contrast is to be seen, above 0 and up to 30; one-sided.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density contrast to see (%)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the change of the mean density along the whole path in percent, above −100 and not 0: −10 for rock that is 10 % lighter.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Trajectories merged along a side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give an odd number of trajectories to take together across and up, from 1: larger bins count more muons and see less detail.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Efficiency</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the share of the muons through all planes that is recorded, above 0 and up to 1.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Statistics of the contrast</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>poisson: exact, for few counts as for many. lesparre: the feasibility formula of Lesparre et al. (2010), for many counts. They agree from about a hundred counts.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rays for each bar</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of rays along a side, 1 to 50, traced for each step from one trajectory to the next. Errors fall with about its square.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density (g/cm³, empty: the material's own)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the mean density in g/cm³, above 0 and up to 30. Empty stands for the material's own: standard_rock 2.65, water 1, ice 0.918, limestone 2.71, dolomite 2.87, quartzite 2.65, granite 2.64, granodiorite 2.73, diorite 2.85, andesite 2.61, basalt 2.99, gabbro 3.03, concrete 2.3.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Maximum range (m, empty: as far as the DEM)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the largest horizontal distance in m at which rock counts, above 0. Rays still in rock there keep the thickness up to it. Empty looks as far as the DEM reaches.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Near field to ignore (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the distance in m within which terrain is ignored, 0 or more: for small bumps at the detector's foot that a DEM cannot resolve.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muons expected along each trajectory in the time given. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposure time (days)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Days until a pixel has counted the muons wanted. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Counting error (%)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard error of the counts, in percent of them. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smallest visible density contrast (%)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smallest decrease of the mean density along the path that the counts show, in percent. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Days to see the density contrast (days)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Days until the density contrast shows. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open-sky muon counts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muons that there would be without the rock. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muon flux (cm⁻² sr⁻¹ day⁻¹)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Integral flux of the muons that get through. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rock thickness (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Length of each ray in rock, 0 in the sky. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Acceptance (cm² sr)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Counts per time are the acceptance times the flux. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table of trajectories</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CSV with a row for each trajectory and units in the header.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of the counts on the mountain with skyline, horizon and target, beside the counting error, the contrast that can be seen and the days that it takes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muons along all known trajectories (per day)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muons along trajectories behind rock (per day)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Median counts behind rock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Median exposure behind rock (days)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Median of the smallest visible contrast (%)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Median time to see the contrast (days)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Trajectories or bins of them</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Trajectories behind rock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Trajectories without counts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Boresight azimuth (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Boresight elevation (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Detector elevation (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Target distance (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposure plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Models</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Answers how long a telescope has to count: expected counts, days of exposure and the smallest visible density contrast along its trajectories, and the last two draped on the terrain that it sees.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Compare muon spectra</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Draws and tabulates muon flux models side by side: the differential spectra at chosen zenith angles, the energy loss of muons in several materials, the energy that rock demands, and the transmission and flux that are left behind it.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Use it to choose a model for a site, to see how far the models lie apart there, and to find where each was made for: lines are faded outside a model's range of energies and angles, and the tables say so point by point. &lt;i&gt;Thickness&lt;/i&gt; and &lt;i&gt;Material&lt;/i&gt; set the amount of rock that the figures mark; the area shaded under the spectrum are the muons that get through it.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;The physics is that of &lt;i&gt;Muon radiography&lt;/i&gt;: the flux at an opacity is the one that a pixel with that opacity has.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Tables are CSV files with the unit in each column's name; what has no answer is left empty.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muon flux models</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Parametrised spectra to compare.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Zenith angles (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>List zenith angles in degrees, from 0 (overhead) to below 90, separated by commas; at most 12.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Thickness of rock (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the thickness of rock in m that the figures mark, above 0 and up to 20000.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Altitude of the detector (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the height above sea level in m, −1000 to 10000; it counts where the correction for altitude is on.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Materials whose energy loss is compared</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The material of the rock is shown in any case.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table of spectra</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CSV: differential flux of every model, zenith angle and kinetic energy, and whether the model was made for it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table of fluxes behind rock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CSV: flux, open sky and transmission of every model, zenith angle and opacity.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table of energy losses</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CSV: stopping power and range of every material, and the polynomial beside it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table of minimum energies</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CSV: kinetic energy that the material demands at every thickness, by each range law.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of spectra, energy losses, minimum energies, transmission and flux.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One HTML file with figures, parameters, numbers, every warning and how to cite.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Opacity of the thickness (g/cm²)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Minimum kinetic energy (GeV)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest over smallest flux of the models that hold</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Import muogram</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Turns a text file into a muogram raster that every other algorithm takes: what a telescope counted, or what another program computed.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Tables&lt;/b&gt; have one line for each direction, in any order: azimuth, elevation or zenith angle, value and, if there is one, its standard error. Columns are found by their names (azimuth, zenith, elevation, flux, counts, error and the like, also in Spanish), or by the names and numbers that you give. Units in the names, such as [rad] or (deg), are heeded. A table without names has the columns azimuth, vertical angle, value and error in this order; say then whether the vertical angle is an elevation or a zenith angle.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Matrices&lt;/b&gt; have one line for each row of pixels. Give the angles of the first and the last column and row, or a reference muogram of the same size.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Files of the first MUYSC&lt;/b&gt; (.dat with the lines Op and Pp) are recognised; detector, target and boresight come from them. Their directions and lengths are approximate.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;A muogram is a regular and complete grid: a direction that is missing, there twice or off the grid is refused with its line. Write nan where nothing was measured.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;The reference muogram, usually the simulated thickness, hands over what it says of detector, target and boresight; whatever is given beside it counts more.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Text table or matrix</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Text file: lines of azimuth, elevation or zenith angle, value and perhaps error in any order, a matrix of values, or a file of the first MUYSC. Tabs, semicolons, commas or blanks separate the numbers.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Quantity of the values</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What the values are. They must be in the unit of the quantity once multiplied by the factor: flux cm⁻² sr⁻¹ day⁻¹, thickness m, opacity g/cm², density g/cm³, open_sky cm⁻² sr⁻¹ day⁻¹, exposure days, distance m.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Layout</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>table: one line for each direction. matrix: one line for each row of pixels. auto: a table if columns are named or directions come again and again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Vertical angle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whether the vertical angle is an elevation above the horizon or a zenith angle. auto takes what the column's name says.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Unit of the angles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Unit of the angles in the file, and of those of a matrix given below. auto takes what the names of the columns say, and else degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Column of the azimuth</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name or number (from 1) of the column of the azimuth. Empty finds it by its name, else the first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Column of the vertical angle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name or number (from 1) of the column of the vertical angle. Empty finds it by its name, else the second.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Column of the values</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name or number (from 1) of the column of the values. Empty finds it by its name, else the third.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Column of the standard errors</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name or number (from 1) of the column of the standard errors. Empty finds it by its name, if there is one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Factor of the values</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number that values and errors are multiplied by, other than 0: 86400 turns a flux per second into one per day, 1000 kilometres into metres.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number for no data (empty: none)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number that stands for a missing value. Words such as nan, and empty fields, always do.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Angles count from the boresight</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whether the angles of the file are measured from the boresight rather than from north and the horizon.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Azimuth grows</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>clockwise as seen from above (north, east, south), or counterclockwise.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Matrix: azimuth of the first column</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the azimuth of the pixel centres in the first column of a matrix, in the unit of the angles. Not needed with a reference muogram of the same size.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Matrix: azimuth of the last column</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the azimuth of the pixel centres in the last column of a matrix, in the unit of the angles. Not needed with a reference muogram of the same size.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Matrix: vertical angle of the first row</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the vertical angle of the pixel centres in the first row of a matrix, in the unit of the angles. Not needed with a reference muogram of the same size.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Matrix: vertical angle of the last row</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the vertical angle of the pixel centres in the last row of a matrix, in the unit of the angles. Not needed with a reference muogram of the same size.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Matrix of errors</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Text file of the standard errors of a matrix, of the same size.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reference muogram</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muogram seen from the same place, such as the thickness: what it says of the detector is taken over, and its directions for a matrix without angles. What is given below counts more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where the telescope stood. As text: x,y [EPSG:code]; without a code longitude and latitude (EPSG:4326).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Detector elevation (m, empty: the reference's)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the altitude of the detector in m, −1000 to 10000; later steps need it for the altitude correction.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Boresight azimuth (°, empty: middle of the picture)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the azimuth that the telescope pointed to, in degrees clockwise from north, −360 to 360.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Boresight elevation (°, empty: middle of the picture)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the elevation that the telescope pointed to, in degrees, −90 to 90.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposure (days, empty: not known)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the days of counting, above 0; kept as DAYS in the muogram.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Acceptance of a pixel (cm² sr, empty: not known)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the acceptance of one pixel in cm² sr, above 0; kept in the muogram.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The values as a GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Errors</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The standard errors, where the file holds any, on the same directions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels without a value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sum of the values</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muon flux through rock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Computes minimum energy, muon flux, transmission and exposure time behind rock that is already known as a muogram of thickness or opacity; no elevation model is needed.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Use it to compare flux models, densities or telescopes on one geometry, or to bring in a thickness from elsewhere. Give exactly one of the two muograms. The detector's elevation, for the altitude correction, is taken from the muogram unless given.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;The physics is that of &lt;i&gt;Muon radiography&lt;/i&gt;; the same input gives the same flux.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muogram of rock thickness in m, as radiography writes it. Give this or an opacity muogram.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Opacity muogram</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muogram of opacity in g/cm². Give this or a thickness muogram.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the altitude of the detector in m, −1000 to 10000, for the altitude correction. Empty takes what the muogram says.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Acceptance of a pixel (cm² sr)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the acceptance of one pixel in cm² sr, above 0. It divides the exposure time.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muons per pixel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of muons wanted in each pixel, above 0. 10 muons give the flux to about 32 %, 100 to 10 %.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A telescope in place of ACCEPTANCE: each pixel then has the acceptance of the telescope in its direction, and none outside its field of view. none takes ACCEPTANCE. A telescope that was built, or custom for the numbers below. A preset wins over numbers, and the log says which were not used. mute: 30 × 30 bars of 4 cm, 250 cm; gibert2010: 32 × 32 bars of 5 cm, 100 cm; carbone2014: 16 × 16 bars of 5 cm, 170 cm; lopresti2020: 99 × 99 bars of 1 cm, 97 cm; lesparre2012: 16 × 16 bars of 5 cm, 115 cm; lesparre2010: 16 × 16 bars of 5 cm, 80 cm; uchida2009: 12 × 12 bars of 7 cm, 100 cm; muraves: 60 × 60 bars of 3.4 cm, 200 cm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Length of each ray in rock, 0 in the sky. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Minimum muon energy (GeV)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Kinetic energy of the slowest muons that get through. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Integral flux of the muons that get through. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open-sky muon flux (cm⁻² sr⁻¹ day⁻¹)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Integral flux that there would be without the rock. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Transmission</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Flux over open-sky flux, 1 in the sky. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Days until a pixel has counted the muons wanted. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smallest muon flux (cm⁻² sr⁻¹ day⁻¹)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smallest flux over the models that hold for the ray's energy and zenith. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest muon flux (cm⁻² sr⁻¹ day⁻¹)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest flux over the models that hold for the ray's energy and zenith. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of thickness and flux side by side, with contours, skyline and target.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest thickness (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels without a flux</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muon radiography</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Simulates what a muon telescope sees of a mountain: rock thickness, opacity, minimum muon energy, muon flux, transmission and exposure time, as rasters of azimuth (to the right, degrees clockwise from north) against elevation angle (upwards).&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose an elevation model, click where the telescope stands and what it points at, and run. The line between the two points is the middle of the field of view.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; Rays are straight and exact on the surface interpolated between the cell centres of the elevation model, with the curvature of the Earth; every ridge on the way counts, as far as the model reaches. Thickness times density is the opacity; the range table of the material turns it into the lowest energy that gets through, and the flux model is integrated from there.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does not know&lt;/b&gt; has no data, never 0, and is counted in the log by cause: rays that reach the edge of the elevation model in rock, pass a gap in it, or point at or below the horizon (no flux model has an answer there, though the thickness is given). Pixels without rock have thickness 0 and transmission 1.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;The rasters describe themselves: &lt;i&gt;Muon flux through rock&lt;/i&gt; and &lt;i&gt;Drape muogram on the terrain&lt;/i&gt; need nothing else.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Azimuth aperture (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the full width of the field of view in azimuth, above 0° and up to 360°.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Elevation aperture (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the full height of the field of view in elevation, above 0° and up to 180°; it must not reach past the zenith.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels in azimuth</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of muogram columns, 1 or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels in elevation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of muogram rows, 1 or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Distance to the first rock (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Length of each ray from the detector to the first rock. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Field of view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Polygons on the map: the sector that the aperture covers, and within it the ground seen, from the nearest to the farthest rock face along each azimuth.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muograms from many sites</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Survey</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Simulates a radiography of one target from every point of a layer, and writes the muograms of all sites into one folder.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose an elevation model and a layer of points, click what the telescopes point at, choose the quantities and a folder, and run. A field of the layer may hold the name of each site, another the height of its telescope above the ground.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; Each site is a &lt;i&gt;Muon radiography&lt;/i&gt; of its own, with the same field of view, rock and telescope. The files are called after the site and the quantity, such as &lt;i&gt;site_01_thickness.tif&lt;/i&gt;. The index is a point layer with the names of these files and the numbers of each site.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Sites that cannot be used&lt;/b&gt;, because they lie off the elevation model or in a gap of it, are skipped, named and counted. The warnings of all sites are gathered: those that differ in numbers alone are said once.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;All files appear together&lt;/b&gt; when the last site is done. Muograms of an earlier run under the same names are replaced; any other file in the way ends the run before it starts.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sites</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Layer of points where telescopes stand, on the DEM, in any coordinate reference system. Sites off the DEM are skipped with a warning.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Field of the names</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Field with the name of each site, which its files begin with. Empty: site_01, site_02 and so on, by the order in the layer.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Field of the heights above ground</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Field with the height of each telescope above the ground in m, −10000 to 10000. Where it is empty the detector height above counts.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Quantities</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What to write for each site, one raster each.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder of the muograms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Holds a GeoTIFF for each site and quantity, such as site_01_thickness.tif. Muograms of an earlier run under the same names are replaced; other files are not.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Index of the muograms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Layer of the sites with the name of each file in the folder, detector elevation, distance and direction of the target, largest thickness, median exposure and unknown pixels.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sites with muograms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sites skipped</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muograms written</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest thickness from any site (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Median over the sites of the median exposure (days)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels without a flux from all sites</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Compare reconstruction methods</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tomography</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Compares the reconstruction methods on the Shepp–Logan head, a test image of ten ellipses whose projections are known exactly: how near each comes, and in what time.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; The head is projected along parallel rays from evenly spaced directions over 180°, noise is added if asked for, and every method reconstructs the image from the same projections. The error is ‖R − T‖ / ‖T‖ of the reconstruction R against the head T, by the sum of squares over all pixels. The rays' paths through the pixels are computed once for all methods, and that time is told apart.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it tells.&lt;/b&gt; Which methods cope with few projections (lower &lt;i&gt;Projections&lt;/i&gt;) or with noise, and how many iterations they take. Filtered back-projection (&lt;i&gt;fbp&lt;/i&gt;) and &lt;i&gt;gridrec&lt;/i&gt; need parallel projections from all around and stand here for comparison alone: muograms look out from single points, so &lt;i&gt;Muon tomography&lt;/i&gt; cannot use them.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Regularisation.&lt;/b&gt; Each method's own strength is the one that serves muograms with noise; on this head with its many projections the penalised methods do better with less of it, such as 0.01.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;The Bayesian method needs the errors of the projections: it is told those of the noise, together with what the pixels' edges make of the projections.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels along an edge</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the edge of the square image in pixels, 16 to 1024. Time and memory grow with its square.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Projections</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of parallel projections, evenly spaced over 180°, 2 to 2000.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Methods</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Methods to compare. fbp and gridrec need parallel projections and so exist here alone; all others serve muograms too.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Noise (%)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the standard deviation of the projections' errors in percent of the largest projection, 0 to 100.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Iterations (empty: each method's own)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the most iterations of every method, 1 or more; a sweep over all rays is one. Methods that converge sooner end sooner.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Relaxation (empty: each method's own)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the share of each correction that art, bart, sart and sirt apply, above 0 and below 2.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Regularisation (empty: each method's own)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the strength of the penalty on rough images, 0 or more; at 1 a step between neighbours weighs as much as the misfit of a pixel.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Seed of the noise</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a whole number, 0 or more; the same seed draws the same noise.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table of methods</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CSV: iterations, seconds, errors and misfit of every method.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of the head and every reconstruction, of error against time and of misfit against iterations.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One HTML file with the panel, parameters, numbers and how to cite.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Method of the smallest error</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smallest relative error</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Time of that method (s)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Relative error of one grey level</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Time of the ray paths, once for all (s)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Can this survey see it?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Shows before a campaign what its muon tomography can find. It puts a known body into the mountain, counts the muons that telescopes would count, reconstructs the densities from them, and says how much of the body is found again.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose an elevation model, click the target, and choose a body. The telescopes stand on the sites of a layer, or on a ring around the target. Each site of the ring is moved a little, to the flattest ground nearby; a steepest slope and a free view may be asked for, and sites without both are left out and counted.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;The known model.&lt;/b&gt; &lt;i&gt;conduit&lt;/i&gt;: an upright cylinder. &lt;i&gt;sphere&lt;/i&gt;. &lt;i&gt;checkerboard&lt;/i&gt;: every other cube, to see where details are resolved. &lt;i&gt;uniform&lt;/i&gt;: no body at all, so that whatever structure comes out is noise. &lt;i&gt; polygons&lt;/i&gt;: bodies from a layer with the fields &lt;i&gt;density&lt;/i&gt; (g/cm³), &lt;i&gt;base&lt;/i&gt; and &lt;i&gt;top&lt;/i&gt; (m above sea level). The rock around has the density given with the physics.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; The thickness of rock comes from the elevation model as in &lt;i&gt;Muon radiography&lt;/i&gt;, the body from voxels of half the size; so the data are not made by the matrix that is inverted. The flux behind it, the acceptance and the days give the muons expected, and counts are drawn from them; the same seed draws the same counts. Counts are turned back into opacity with their errors, as in &lt;i&gt;Density from a measured muogram&lt;/i&gt;. Neighbouring pixels are merged up to a number of counts: pixels without a muon say no density, and leaving them out would make the rock look too light. Then the densities are found as in &lt;i&gt;Muon tomography&lt;/i&gt;. The real terrain is known better or worse than its model; here the model is the truth.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Reading the result.&lt;/b&gt; &lt;i&gt;Contrast&lt;/i&gt;: that found over the true one, 1 where the whole of it is found. &lt;i&gt;Spread&lt;/i&gt;: standard deviation of the errors; for the model uniform, of the densities themselves. The errors of the views compare the sums along the three axes, as lengths in rock; the top view is normalised. Only voxels that a ray passes are compared, and the others are counted.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Choosing the settings.&lt;/b&gt; Run the model uniform first: a prior, or a regularisation, under which the mountain stays uniform suits the noise. With the same settings, see then what is left of the body. Neither needs to know the answer.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Time.&lt;/b&gt; The defaults answer in well under a minute. The finest voxels that make sense are those that two neighbouring rays tell apart.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sites (empty: a ring around the target)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sites on the ring</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of sites on the ring, 1 or more, where no layer of sites is given.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Radius of the ring (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the horizontal distance of the sites from the target in m, above 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Azimuth of the first site (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the azimuth of the first site as seen from the target, in degrees clockwise from north. The others follow clockwise, evenly spaced.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Azimuth where the arc ends (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the azimuth of the last site in degrees. A whole turn after the first is a full ring.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sites may be moved by (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give how far in m a site may be moved to flatter ground, 0 or more, less than the radius.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Steepest slope at a site (°, empty: any)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the steepest ground in degrees, above 0 and up to 90, on which a site of the ring may lie. Sites without such ground nearby are left out.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sites of the ring see the target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whether sites are left out if ground rises above the line to the target on the nearest quarter of the way.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Known model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>uniform: rock of one density. conduit: an upright cylinder. sphere. checkerboard: every other cube. polygons: what a layer holds.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density of the rock around (g/cm³, empty: the material's own)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the density of the rock around the bodies in g/cm³, above 0 and up to 30.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density of the body (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the density of conduit, sphere or every other cube in g/cm³, above 0 and up to 30.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Radius of conduit or sphere (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the radius in m, above 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edge of the checkerboard's cubes (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the edge of a cube in m, above 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Position of the body (empty: the target)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Axis of the conduit or middle of the sphere, on the DEM.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Base of the conduit (m, empty: the volume's)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the height of the conduit's lower end in m above sea level.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Top of the conduit (m, empty: the volume's)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the height of the conduit's upper end in m above sea level; above the ground there is none of it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Middle of the sphere (m, empty: the volume's)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the height of the sphere's middle in m above sea level.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Polygons of the model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Layer of bodies for the model polygons, with the fields density (g/cm³), base and top (m above sea level); in any coordinate reference system. Later ones replace earlier ones.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Days of counting</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the days that each station counts, above 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the acceptance of one pixel in cm² sr, above 0. Counts grow with it and with the days.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Counting noise</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whether muons are counted. If not, every opacity is known, with the error given below: what the geometry alone can show.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Merge pixels up to this many counts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the counts up to which neighbouring pixels are merged, 0 or more; 0 merges none. Pixels without a muon say no density, and leaving them out would make the rock look lighter than it is.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a whole number, 0 or more; the same seed draws the same counts.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Extent of the volume (empty: where the muograms look)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rectangle on the map, as text xmin,xmax,ymin,ymax [EPSG:code], on the elevation model. Empty takes the rectangle with nine tenths of the rock on the rays.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Voxel size (m, empty: by the number of voxels)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the edge of a voxel in m, above 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Voxels along the longest side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of voxels along the longest side of the volume, 1 to 1000. It counts where no voxel size is given, which is then rounded up.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Base of the volume (m, empty: the lowest rays)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the height of the volume's floor in m above sea level, below its top. Empty takes where all but the lowest 2 % of the rock on the rays is above it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Top of the volume (m, empty: the highest ground)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the height of the volume's ceiling in m above sea level, above its base.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Coordinate reference system (empty: the elevation model's or UTM)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Projected coordinate reference system of the volume, true to scale there. Empty takes that of the elevation model if it is one in metres, else the UTM zone.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Voxels of air are known</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whether rock ends at the terrain. If not, all voxels are unknown and the rays of the sky count too: the shape of the mountain is reconstructed with its density.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Memory (GiB)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the most memory in GiB for the paths of the rays, above 0. Where they need more, they are computed anew at every step, which is slow.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Method</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>How densities are found. art: ART (Kaczmarz); bart: ART by blocks; sart: SART; sirt: SIRT; mlem: MLEM; osem: OSEM; pml-quad: Penalised likelihood, quadratic; pml-hybrid: Penalised likelihood, hybrid; ospml-quad: Penalised likelihood by subsets, quadratic; ospml-hybrid: Penalised likelihood by subsets, hybrid; tv: Total variation; grad: Gradient descent; tikhonov: Tikhonov; lsmr: Damped LSMR; bayes: Bayesian, Gaussian prior. Those of the family art and sirt follow the data alone; pml, tv, grad, tikhonov and lsmr prefer smooth models, tv with sharp edges; bayes weighs data against a prior and tells its errors.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Iterations (empty: the method's own)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the most iterations, 1 or more; a sweep over all rays is one. Methods that reach the data's errors or converge end sooner.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Relaxation (empty: the method's own)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Regularisation (empty: the method's own)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the strength of the penalty on rough models of pml, ospml, tv, grad, tikhonov and lsmr, 0 or more; at 1 a step between neighbours weighs as much as the misfit of a voxel.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reference density (g/cm³, empty: the muograms' mean)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the density in g/cm³, above 0 and up to 30, of the rock outside the volume, of the start and of the prior.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Error of the opacities (%)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the standard error of opacities in % where there are no rasters of errors, 0 or more. 0 stands for unknown: then all rays count the same, no method stops at the errors, and bayes cannot be used.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Error of the path lengths (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the standard error of a ray's length in rock in m, 0 or more: what the elevation model does not show. It adds to the other errors.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep densities above zero</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whether densities below zero are lifted to it; bayes does not.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Highest density (g/cm³, empty: none)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the density in g/cm³, above 0, that none may exceed, such as that of the rock without pores; bayes knows none.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Order of the rays</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>interleaved: stations far apart take turns. sequential: as they come. random: drawn.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Subsets (empty: the method's own)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of parts of bart, osem and ospml that the rays are dealt into, 1 or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop at this multiple of the errors</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the misfit, in standard errors, at which the methods without a penalty stop, 0 or more; 0 never stops.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density step of the hybrid penalty (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the step between neighbours in g/cm³, above 0, from which the penalty of pml-hybrid and ospml-hybrid grows no faster than the step.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard deviation of the prior (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give how far densities are from the reference before any muon, in g/cm³, above 0; for bayes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correlation length of the prior (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the distance in m, above 0, over which densities are alike; for bayes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Draws for the error of the density</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give how often bayes solves for drawn data, 1 or more, where the error of the density is wanted from more than 2000 rays; n draws tell it to 71/√n %.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density of each voxel with rock that a ray passes. A GeoTIFF on the map with a band for each elevation slice, the lowest first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rays per voxel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of rays through each voxel with rock. A GeoTIFF on the map with a band for each elevation slice, the lowest first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Error of the density (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard error of each density, of the method bayes. A GeoTIFF on the map with a band for each elevation slice, the lowest first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Voxels as points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Centre of each voxel with a density as a point with height, with density, rays and, where there is one, the error: for 3-D views.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Residuals</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CSV: what the densities leave unexplained of each muogram.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density of the known model in the same voxels. A GeoTIFF on the map with a band for each elevation slice, the lowest first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stations</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sites that were used, with their direction and distance to the target.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table of errors</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CSV: contrast, errors of the densities and of the views, and the numbers of the run.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of the known model, of what is found and of the error, summed from the top, the front and the side, and in slices through the target.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One HTML file with the panel, what is found of each body, the misfit by iteration and station, parameters, numbers, every warning and how to cite.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Contrast found over the true one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Relative error of the densities</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard deviation of the errors (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean of the errors (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Top view, normalised: mean |ε|</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Top view, normalised: σ of |ε|</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Front view: mean |ε| (km)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Front view: σ of |ε| (km)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Side view: mean |ε| (km)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Side view: σ of |ε| (km)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muons counted</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sites used</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rays used</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Voxels with a density</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Voxels with rock that no ray passes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Residual over data</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean square of residuals over their errors</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Iterations done</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where to put the telescope</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Tells from which of many places around a target a telescope sees it best: maps of exposure time, share of the target seen, thickness of rock, free sky and a score, the best sites, and a set of sites for several telescopes.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose an elevation model, click the target, say how far away telescopes may stand and how far apart candidates are, and run. Slope, height, roads and a mask narrow the candidates; a point layer replaces the grid.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; Every candidate is a &lt;i&gt;Muon radiography&lt;/i&gt; of its own, aimed at the target. The target body is a vertical cylinder around the target, from the ground down to a depth below it, filled with points of equal volume. Each takes thickness and exposure time of the pixel in its direction, and is seen where the rock is between the thinnest and the thickest.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;The score&lt;/b&gt;, 0 to 1, is the mean over the body of T/(T + d) where it is seen and 0 elsewhere, for the T days of the campaign and the d days until the pixel has its muons. It is 1/2 where the campaign just brings the muons wanted everywhere.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Telescopes that go together.&lt;/b&gt; A telescope covers the azimuths around the target with its score, which falls linearly to 0 at the angle given. One after the other the site is taken that raises the mean over all azimuths most. The layer is ready for &lt;i&gt;Muograms from many sites&lt;/i&gt;.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Long surveys.&lt;/b&gt; All processors compute. A survey that was stopped goes on when it is run again with the same SCORE; what is finished waits in a folder beside it, named after it with &lt;i&gt;.partial&lt;/i&gt;, which is removed at the end. SCHEDULER sends the work to a Dask cluster.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Not seen&lt;/b&gt; is also what lies outside the field of view or behind unknown rock; the log says how much that is.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smallest distance to the target (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the horizontal distance in m within which no telescope stands, 0 or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest distance to the target (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the horizontal distance in m beyond which no telescope stands, above 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Spacing of candidates and maps (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the distance between candidates in m, above 0: also the cell size of the maps. Half of it makes four times as many candidates.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Steepest slope (°, empty: any)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the steepest ground in degrees, above 0 and up to 90, measured over one cell of the DEM to each side.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Highest above the target (m, empty: any)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give how much the ground at a candidate may be above the ground at the target in m; negative where it must be below.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lowest below the target (m, empty: any)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give how much the ground at a candidate may be below the ground at the target in m; negative where it must be above.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Roads</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Layer of lines that telescopes must be near, in any coordinate reference system.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest distance to a road (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the distance in m to the nearest road beyond which no telescope stands, above 0. It counts where ROADS is given.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mask of candidates</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Raster that says where telescopes may stand: anywhere that its first band is neither 0 nor no data. In any coordinate reference system.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Candidates</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Layer of points to choose from, in place of a grid around the target. The limits hold for them too.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Radius of the target body (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the radius in m of the part of the mountain that matters, above 0: a vertical cylinder around the target.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Depth of the target body (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give how far in m below the ground at the target the target body reaches, above 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Thinnest rock to see through (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the thickness of rock in m below which a ray says nothing of the target, 0 or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Thickest rock to see through (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the thickness of rock in m above which too few muons come through, above the thinnest.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Days of the campaign</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the days that telescopes will count, above 0. The score weighs exposure times against it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of best sites</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give how many of the best candidates to list, 1 or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Distance between best sites (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give how far in m the best sites are from each other at the least, 0 or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of telescopes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give how many telescopes are to cover the target's sides together, 1 or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Angle that a telescope covers (°, empty: 360° over their number)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the angle around the target in degrees, above 0 and up to 360, to either side of a telescope, at which it adds nothing any more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Worker processes (empty: one for each processor)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number of processes that compute, 0 or more; 0 and 1 compute in QGIS itself.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Dask scheduler (empty: this machine)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Address of the scheduler of a Dask cluster, such as tcp://10.0.0.1:8786, whose workers compute in place of this machine. It needs the Python library distributed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Score</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From 0 to 1: the mean over the target body of T/(T + d) where it is seen and 0 elsewhere, for T days of the campaign and d days until the pixel has its muons. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Days to the muons wanted</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Median days until a pixel behind which the target body lies has the muons wanted. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Share of the target seen</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Share of the target body's volume that is seen through rock between the thinnest and the thickest, 0 to 1. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Median thickness through the target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Median length in rock of the rays through the target body. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smallest thickness through the target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Least length in rock of the rays through the target body. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest thickness through the target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Greatest length in rock of the rays through the target body. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Share of free sky</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Share of the pixels that see only sky, 0 to 1: where the telescope is calibrated. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Best sites</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Points of the candidates with the highest scores and their numbers, best first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Telescopes that go together</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Points of the sites that cover the azimuths around the target best, in the order of choice: the layer of sites for Muograms from many sites.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Candidates that see a part of the target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Highest score</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Days to the muons wanted at the best site</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Share of the target seen from the best site</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean coverage of the azimuths by the telescopes that go together</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Telescope parameters</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Computes what a telescope of pixel planes collects from each of its directions: acceptance, solid angle, detection area, path length and angular resolution.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose a telescope that was built, or &lt;i&gt;custom&lt;/i&gt; and give the number of bars, their width and the separation of the planes. A preset wins over numbers of your own.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; A muon is known by its pixel in the front plane and its pixel in the back plane. Pairs of pixels with the same offset look the same way and make one trajectory: (2N − 1)² of them for N × N bars. The formula &lt;i&gt;exact&lt;/i&gt; integrates over both pixels, so that all trajectories together collect what the two whole planes do; &lt;i&gt;paper&lt;/i&gt; is the one that MUYSC was published with. Planes in between change nothing.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;The rasters&lt;/b&gt; have the tangent of the angle from the boresight as axes, the telescope's right as x and its up as y: one pixel is the width of a bar over the separation, everywhere.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Solid angle (sr)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Solid angle of the directions that belong to each trajectory. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Detection area (cm²)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Area of the front plane from which each trajectory reaches the back plane. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Path between the planes (cm)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Length from plane to plane along each trajectory. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Angular resolution (mrad)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Square root of the solid angle: the full width of the response. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of the telescope and its aperture, with acceptance, solid angle, detection area and path length as maps and sections.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Comparison</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of this telescope beside all that were built.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One HTML file with figures, parameters, numbers and how to cite.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest acceptance of a trajectory (cm² sr)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest solid angle of a trajectory (sr)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest detection area (cm²)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Half aperture across (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Half aperture up (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Angle from one trajectory to the next (mrad)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Trajectories</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Étendue, all acceptances together (cm² sr)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muon tomography</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;Finds the density of the rock in three dimensions from muograms of several stations.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What you need.&lt;/b&gt; Muograms of one quantity, and the elevation model they were seen on. &lt;b&gt;Density&lt;/b&gt; (from &lt;i&gt;Density from a measured muogram&lt;/i&gt;), &lt;b&gt;opacity&lt;/b&gt;, &lt;b&gt;flux&lt;/b&gt; or &lt;b&gt;transmission&lt;/b&gt; show the inside of the mountain; flux and transmission are turned into opacity with the physics that the files name. &lt;b&gt;Thickness&lt;/b&gt; shows its shape alone. Rasters of errors are found by detector and directions. Without them an error in percent is assumed. The more sides the stations look from, the better: one station alone cannot tell near rock from far.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; Each pixel is a straight ray. Its lengths in the voxels are exact, cut off where the terrain begins and ends, with the Earth's curvature and the true north and scale of the projection. Voxels of air are no unknowns. Rock on the ray outside the volume is taken off at the reference density. Then the method finds the densities whose integrals along the rays are the opacities.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Which method.&lt;/b&gt; &lt;i&gt;bayes&lt;/i&gt; (default) weighs the data by their errors against a prior about the reference density: where rays say little, the density stays near it. It tells the error of each density. &lt;i&gt;tv&lt;/i&gt; prefers bodies with sharp edges; its regularisation must suit the noise. &lt;i&gt;sirt&lt;/i&gt;, &lt;i&gt;art&lt;/i&gt;, &lt;i&gt;sart&lt;/i&gt;, &lt;i&gt;mlem&lt;/i&gt; and their relatives follow the data and stop at their errors. Filtered back-projection and Gridrec need parallel rays and are refused.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;The volume.&lt;/b&gt; Without an extent, it is where the muograms look. Voxels much smaller than the distance between rays cost memory and show nothing. Where the paths do not fit the memory, they are computed anew at each step.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What comes out.&lt;/b&gt; &lt;i&gt;Density&lt;/i&gt;, &lt;i&gt;rays per voxel&lt;/i&gt; and &lt;i&gt;error of the density&lt;/i&gt; are GeoTIFFs on the map with a band for each elevation slice, the lowest first; each band is named after the height of its centre. The slice of the target is shown first. From QGIS 3.38 on, the elevation controller steps through them. Voxels in air and those that no ray passes have no data; they and the pixels that were not used are counted in the log, by cause.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Residuals&lt;/b&gt; tell for each muogram what the densities leave unexplained. Chi squared per ray is about 1 where model and errors are right. Much more means that errors are too small, or that muograms contradict each other.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muograms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muograms of one quantity from several stations: density, opacity, flux, transmission or thickness, or rasters in telescope angles. They say themselves what they hold and where their detectors stand.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Errors of the muograms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rasters of the standard errors, such as density error, one for each muogram, in any order: they are matched by detector and directions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Line of a vertical section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Layer whose first line says where the vertical section runs; in any coordinate reference system.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Vertical section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of the densities below the line, with the ground.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of slices and sections through the target, views from the top, the front and the side, and the rays per voxel, with a map of the stations.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One HTML file with the panel, the misfit by iteration and station, parameters, numbers, every warning and how to cite.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean density of the voxels (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reference density used (g/cm³)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Volcano survey</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt;p&gt;From an elevation model, a detector and a target to maps: simulates the muograms of the field of view and drapes thickness and flux on the terrain that the detector sees. All layers arrive with their colours, and the report tells the rest.&lt;/p&gt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Plan a muon telescope</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The command is on the clipboard; its files appear where it is run.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Candidate sites</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Run…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open the Processing dialog with these values</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copy as command</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A qgis_process line that computes the same in a terminal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The command is on the clipboard; it reads the DEM in the system of its file, {own}, in place of {given}: assign that to the file first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copy picture</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save picture…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Notes ({number})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Azimuth from north (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Elevation (°)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>open sky</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>unknown</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save picture</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path} cannot be written; choose another folder or close the file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose an elevation model (DEM); add one to the project if there is none.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pick the detector: press the button and click where the telescope stands.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pick the target: press the button and click what the telescope points at.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The muogram cannot be computed ({error}); choose other values.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Azimuth {azimuth}° {letters}, elevation {elevation}°, zenith {zenith}°</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open sky</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rock of unknown thickness</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Flux {flux}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposure {exposure}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Target {distance} away, azimuth {azimuth}°, elevation {elevation}°</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rock {thickness}, opacity {opacity}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Up to {thickness} of rock, median exposure {exposure}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Section along a ray</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>through the pixel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Section along azimuth {azimuth}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose an elevation model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Raster of terrain heights that holds detector, target and rock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pick detector</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pick target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Height of the detector above ground, negative below</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Height of the target above ground, negative inside</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Full width of the field of view in azimuth</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Full height of the field of view in elevation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>as material</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Acceptance of one pixel; a telescope has its own</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source> per pixel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of muons that the exposure time is for</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source> days</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Time of counting that the muon counts are for</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>DEM</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Above ground</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rock, muons and time</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Free aperture</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Flux model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Acceptance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Muons</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Counting time</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The layer {name} cannot be changed; save it as a GeoPackage.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Site {number}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Days: until the pixel towards the target has {muons} muons.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Being computed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add the detector as a site</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use the site as detector</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Zoom to the site</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove the sites chosen</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pick a detector and add it here to compare places.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Distance of the target {distance}
Largest thickness {thickness}
Rock towards the target {rock}
Pixels unknown {unknown} of {pixels}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Site</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name; press F2 to change it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Away (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Horizontal distance of the target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rock (m)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest thickness in the field of view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Days</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Time until the pixel towards the target has its muons</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{number} days</source>
      <translation type="unfinished" />
    </message>
  </context>
</TS>
