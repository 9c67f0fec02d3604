<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
  <context>
    <name>MUYSC</name>
    <message>
      <source>Density from a measured muogram</source>
      <translation>Densidad a partir de un muograma medido</translation>
    </message>
    <message>
      <source>Radiography</source>
      <translation>Radiografía</translation>
    </message>
    <message>
      <source>&lt;p&gt;Computes the mean density along each ray from what a telescope measured, with its error: the inverse of &lt;i&gt;Muon radiography&lt;/i&gt;, with the same physics.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Calcula la densidad media a lo largo de cada rayo a partir de lo que midió un telescopio, con su error: el problema inverso de &lt;i&gt;Radiografía de muones&lt;/i&gt;, con la misma física.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What you need.&lt;/b&gt; The elevation model, or else a muogram of rock thickness (from &lt;i&gt;Muon radiography&lt;/i&gt;) on the same directions; and one of: muon &lt;b&gt;counts&lt;/b&gt; with exposure and acceptance; counts with those of the same telescope in the &lt;b&gt;open sky&lt;/b&gt;, so that acceptance and efficiency drop out, wherever in the sky it pointed; a measured &lt;b&gt;flux&lt;/b&gt;; or a measured &lt;b&gt;transmission&lt;/b&gt;. &lt;i&gt;Import muogram&lt;/i&gt; reads all of them from text.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué se necesita.&lt;/b&gt; El modelo de elevación, o bien un muograma de espesor de roca (de &lt;i&gt;Radiografía de muones&lt;/i&gt;) en las mismas direcciones; y uno de estos: &lt;b&gt;conteos&lt;/b&gt; de muones con exposición y aceptancia; conteos con los del mismo telescopio en &lt;b&gt;cielo abierto&lt;/b&gt;, de modo que la aceptancia y la eficiencia se cancelan, dondequiera que apuntara en el cielo; un &lt;b&gt;flujo&lt;/b&gt; medido; o una &lt;b&gt;transmisión&lt;/b&gt; medida. &lt;i&gt;Importar muograma&lt;/i&gt; los lee todos de texto.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;With the elevation model&lt;/b&gt; every pixel is seen with all the rays of its response, rock and sky at the skyline alike, and its density is the one with which as many muons are expected as were counted. Without it one ray stands for a pixel: those that the skyline crosses, or in which the thickness changes so much that the density is off by more than its error, then have no density.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Con el modelo de elevación&lt;/b&gt; cada píxel se ve con todos los rayos de su respuesta, roca y cielo por igual en el perfil del horizonte, y su densidad es aquella con la que se esperan tantos muones como se contaron. Sin él un rayo representa un píxel: los que cruza el perfil del horizonte, o en los que el espesor cambia tanto que la densidad se aparta más que su error, no tienen entonces densidad.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;Counts in telescope angles work too. If they say which telescope they are of, as those of &lt;i&gt;Expected counts in a telescope&lt;/i&gt; do, they need no acceptance; else give that of every pixel, or a run in the open sky. Rasters, panel and report are then in telescope angles.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Los conteos en ángulos del telescopio también sirven. Si dicen de qué telescopio son, como los de &lt;i&gt;Conteos esperados en un telescopio&lt;/i&gt;, no necesitan aceptancia; si no, indique la de cada píxel, o una medición en cielo abierto. Los rásteres, el panel y el informe están entonces en ángulos del telescopio.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; The opacity is found for which the flux model, attenuated in rock, gives the flux measured; divided by the thickness it is the density. Density contains the error of counting and, if given, the uncertainty of the flux model. From 20 counts on the error is σ/ρ = N&lt;sup&gt;−1/2&lt;/sup&gt; divided by the slope of the flux; below, it follows from exact confidence intervals, whose ends (&lt;i&gt;density lower&lt;/i&gt; and &lt;i&gt;upper&lt;/i&gt;) are then not symmetric.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué hace.&lt;/b&gt; Busca la opacidad para la cual el modelo de flujo, atenuado en la roca, da el flujo medido; dividida por el espesor es la densidad. La densidad incluye el error de conteo y, si se indica, la incertidumbre del modelo de flujo. A partir de 20 conteos el error es σ/ρ = N&lt;sup&gt;−1/2&lt;/sup&gt; dividido por la pendiente del flujo; por debajo se obtiene de intervalos de confianza exactos, cuyos extremos (&lt;i&gt;densidad inferior&lt;/i&gt; y &lt;i&gt;superior&lt;/i&gt;) ya no son simétricos.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Merging.&lt;/b&gt; Neighbouring pixels are merged into rectangles that reach a minimum of counts, 20 if nothing else is given; each has the one density that explains its counts, with the rock of every pixel as it is. 0 leaves every pixel alone.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Unión.&lt;/b&gt; Los píxeles vecinos se unen en rectángulos que alcanzan un mínimo de conteos, 20 si no se indica otra cosa; cada uno tiene la única densidad que explica sus conteos, con la roca de cada píxel tal como es. 0 deja cada píxel solo.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Flags.&lt;/b&gt; 0 measured; 1 no rock, no data; 2 no muon was counted: the density is a lower limit at the confidence chosen and has no error; 3 as bright as the open sky: density 0; 4 measurement or thickness missing; 5 no density explains the flux, or the ray is at or below the horizon; 6 too little rock to stop any of the muons that count, no data; 7 skyline or rock of many lengths in the pixel, of which one ray says too little, no data.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Indicadores.&lt;/b&gt; 0 medido; 1 sin roca, sin dato; 2 no se contó ningún muon: la densidad es un límite inferior con la confianza elegida y no tiene error; 3 tan brillante como el cielo abierto: densidad 0; 4 falta la medición o el espesor; 5 ninguna densidad explica el flujo, o el rayo está en el horizonte o por debajo; 6 demasiado poca roca para frenar alguno de los muones que cuentan, sin dato; 7 perfil del horizonte o roca de muchas longitudes en el píxel, de las que un rayo dice demasiado poco, sin dato.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Mean density.&lt;/b&gt; For counts, the one density that lets through as many muons as were counted in all, pixels without a muon included, each weighted by what it would tell; alike for flux and transmission. Pixels far off count for less, so that a few do not rule. The uncertainty of the flux model does not average out.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Densidad media.&lt;/b&gt; Para conteos, la única densidad que deja pasar tantos muones como se contaron en total, incluidos los píxeles sin muones, cada uno ponderado por lo que diría; lo mismo para flujo y transmisión. Los píxeles muy apartados cuentan menos, para que unos pocos no dominen. La incertidumbre del modelo de flujo no se promedia.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What cannot be&lt;/b&gt; is told with cause and remedy: densities that no rock has, more scatter than the errors say, and open sky in the same muogram that contradicts the acceptance.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Lo que no puede ser&lt;/b&gt; se dice con causa y remedio: densidades que ninguna roca tiene, más dispersión de la que dicen los errores, y cielo abierto en el mismo muograma que contradice la aceptancia.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Smallest and largest density&lt;/b&gt; are the spread over the flux models that hold for each ray's energy and zenith angle.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;La densidad menor y la mayor&lt;/b&gt; son la dispersión entre los modelos de flujo válidos para la energía y el ángulo cenital de cada rayo.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Thickness muogram</source>
      <translation>Muograma de espesor</translation>
    </message>
    <message>
      <source>Muogram of rock thickness in m, seen from the same place on the same directions. One ray then stands for each pixel, and those at the skyline have no density. Give this or, better, the DEM.</source>
      <translation>Muograma de espesor de roca en m, visto desde el mismo lugar en las mismas direcciones. Un rayo representa entonces cada píxel, y los del perfil del horizonte no tienen densidad. Indique este o, mejor, el DEM.</translation>
    </message>
    <message>
      <source>Elevation model (DEM)</source>
      <translation>Modelo de elevación (MDE)</translation>
    </message>
    <message>
      <source>Raster of terrain heights. Each pixel is then seen through it with all its rays, rock and sky at the skyline alike, and the thickness is not needed.</source>
      <translation>Ráster de alturas del terreno. Cada píxel se ve entonces a través de él con todos sus rayos, roca y cielo por igual en el perfil del horizonte, y el espesor no hace falta.</translation>
    </message>
    <message>
      <source>Band of the heights</source>
      <translation>Banda de las alturas</translation>
    </message>
    <message>
      <source>Number of the raster band that holds the heights, from 1.</source>
      <translation>Número de la banda del ráster que contiene las alturas, desde 1.</translation>
    </message>
    <message>
      <source>Unit of the heights</source>
      <translation>Unidad de las alturas</translation>
    </message>
    <message>
      <source>auto takes the unit that the raster states, and metres where it states none.</source>
      <translation>auto toma la unidad que declara el ráster, y metros si no declara ninguna.</translation>
    </message>
    <message>
      <source>Detector (empty: as the muogram says)</source>
      <translation>Detector (vacío: como dice el muograma)</translation>
    </message>
    <message>
      <source>Where the muons were counted, on the DEM. As text: x,y [EPSG:code]. Empty takes DETECTOR_LON and DETECTOR_LAT from the metadata of the measured muogram.</source>
      <translation>Dónde se contaron los muones, sobre el DEM. Como texto: x,y [EPSG:code]. Vacío toma DETECTOR_LON y DETECTOR_LAT de los metadatos del muograma medido.</translation>
    </message>
    <message>
      <source>Detector height above ground (m, empty: as the muogram says)</source>
      <translation>Altura del detector sobre el suelo (m, vacío: como dice el muograma)</translation>
    </message>
    <message>
      <source>Give the height of the telescope above the ground of the DEM in m, −10000 to 10000. Empty takes what the muogram says: its height above ground, else its elevation.</source>
      <translation>Indique la altura del telescopio sobre el suelo del DEM en m, de −10000 a 10000. Vacío toma lo que dice el muograma: su altura sobre el suelo o, si no, su elevación.</translation>
    </message>
    <message>
      <source>Muon counts</source>
      <translation>Conteos de muones</translation>
    </message>
    <message>
      <source>Muogram of muons counted in each pixel, whole numbers. Give exactly one of counts, flux and transmission.</source>
      <translation>Muograma de los muones contados en cada píxel, números enteros. Indique exactamente uno: conteos, flujo o transmisión.</translation>
    </message>
    <message>
      <source>Measured flux</source>
      <translation>Flujo medido</translation>
    </message>
    <message>
      <source>Muogram of measured flux in cm⁻² sr⁻¹ day⁻¹.</source>
      <translation>Muograma del flujo medido en cm⁻² sr⁻¹ day⁻¹.</translation>
    </message>
    <message>
      <source>Measured transmission</source>
      <translation>Transmisión medida</translation>
    </message>
    <message>
      <source>Muogram of measured transmission, flux over that of the open sky in the same direction, from 0 to 1.</source>
      <translation>Muograma de la transmisión medida, el flujo dividido por el de cielo abierto en la misma dirección, de 0 a 1.</translation>
    </message>
    <message>
      <source>Errors of flux or transmission</source>
      <translation>Errores del flujo o de la transmisión</translation>
    </message>
    <message>
      <source>Muogram of the standard errors of a measured flux or transmission, as the import writes it. Counts need none.</source>
      <translation>Muograma de los errores estándar de un flujo o una transmisión medidos, como lo escribe la importación. Los conteos no lo necesitan.</translation>
    </message>
    <message>
      <source>Exposure (days, empty: as the counts say)</source>
      <translation>Exposición (días, vacío: la que indican los conteos)</translation>
    </message>
    <message>
      <source>Give the days of counting, above 0. Empty takes DAYS from the counts' metadata.</source>
      <translation>Indique los días de conteo, mayor que 0. Vacío toma DAYS de los metadatos de los conteos.</translation>
    </message>
    <message>
      <source>Acceptance of a pixel (cm² sr, empty: as the counts say)</source>
      <translation>Aceptancia de un píxel (cm² sr, vacío: la que indican los conteos)</translation>
    </message>
    <message>
      <source>Give the acceptance of one pixel in cm² sr, above 0, detection efficiency included. Empty takes ACCEPTANCE from the counts' metadata. Not used with an open-sky run.</source>
      <translation>Indique la aceptancia de un píxel en cm² sr, mayor que 0, incluida la eficiencia de detección. Vacío toma ACCEPTANCE de los metadatos de los conteos. No se usa con una medición a cielo abierto.</translation>
    </message>
    <message>
      <source>Acceptances of the pixels</source>
      <translation>Aceptancias de los píxeles</translation>
    </message>
    <message>
      <source>Raster of the acceptance of every pixel in cm² sr, in place of one for all, such as Telescope parameters writes it for counts in telescope angles.</source>
      <translation>Ráster de la aceptancia de cada píxel en cm² sr, en lugar de una sola para todos, como lo escribe Parámetros del telescopio para conteos en ángulos del telescopio.</translation>
    </message>
    <message>
      <source>Counts in the open sky</source>
      <translation>Conteos a cielo abierto</translation>
    </message>
    <message>
      <source>Muogram of muons that the same telescope pixels counted in the open sky. Acceptance and efficiency then drop out. Its elevations say where the telescope pointed.</source>
      <translation>Muograma de los muones que contaron los mismos píxeles del telescopio a cielo abierto. La aceptancia y la eficiencia se cancelan entonces. Sus elevaciones dicen adónde apuntaba el telescopio.</translation>
    </message>
    <message>
      <source>Exposure in the open sky (days, empty: as its counts say)</source>
      <translation>Exposición a cielo abierto (días, vacío: la que indican sus conteos)</translation>
    </message>
    <message>
      <source>Give the days of counting in the open sky, above 0. Empty takes DAYS from the metadata of the counts in the open sky.</source>
      <translation>Indique los días de conteo a cielo abierto, mayor que 0. Vacío toma DAYS de los metadatos de los conteos a cielo abierto.</translation>
    </message>
    <message>
      <source>Merge pixels up to (counts, 0: no merging)</source>
      <translation>Agrupar píxeles hasta (conteos, 0: sin agrupar)</translation>
    </message>
    <message>
      <source>Give the counts that each region of merged pixels must reach, 0 or more. Neighbouring pixels then share one density. 20 and more make the errors symmetric. With a DEM counts are those expected through rock, less what the sky beside it hides. Only for counts.</source>
      <translation>Indique los conteos que debe alcanzar cada región de píxeles unidos, 0 o más. Los píxeles vecinos comparten entonces una densidad. 20 o más hacen simétricos los errores. Con un DEM los conteos son los esperados a través de la roca, menos lo que oculta el cielo al lado. Solo para conteos.</translation>
    </message>
    <message>
      <source>Uncertainty of the flux model (%, empty: the model's own)</source>
      <translation>Incertidumbre del modelo de flujo (%, vacío: la propia del modelo)</translation>
    </message>
    <message>
      <source>Give the relative uncertainty of the flux in %, from 0 to below 100. It is the same for all pixels and does not average out. Empty takes the standard error of gsf-sibyll at the minimum energies, 5 % to 12 % as a rule, or 15 % for a formula.</source>
      <translation>Indique la incertidumbre relativa del flujo en %, de 0 a menos de 100. Es la misma para todos los píxeles y no se promedia. Vacío toma el error estándar de gsf-sibyll a las energías mínimas, por lo general de 5 % a 12 %, o 15 % para una fórmula.</translation>
    </message>
    <message>
      <source>Confidence of lower limits (%)</source>
      <translation>Confianza de los límites inferiores (%)</translation>
    </message>
    <message>
      <source>Give the one-sided confidence in % of the lower limit on density in pixels without a muon, above 50 and below 100.</source>
      <translation>Indique la confianza unilateral en % del límite inferior de la densidad en píxeles sin ningún muon, mayor que 50 y menor que 100.</translation>
    </message>
    <message>
      <source>Detector elevation (m, empty: the muogram's)</source>
      <translation>Elevación del detector (m, vacío: la del muograma)</translation>
    </message>
    <message>
      <source>Give the altitude of the detector in m, −1000 to 10000, for the altitude correction. Empty takes what the muograms say.</source>
      <translation>Indique la altitud del detector en m, de −1000 a 10000, para la corrección por altitud. Vacío toma lo que dicen los muogramas.</translation>
    </message>
    <message>
      <source>Material</source>
      <translation>Material</translation>
    </message>
    <message>
      <source>Rock or other matter, whose stopping power slows the muons.</source>
      <translation>Roca u otra materia, cuyo poder de frenado desacelera los muones.</translation>
    </message>
    <message>
      <source>Muon flux model</source>
      <translation>Modelo de flujo de muones</translation>
    </message>
    <message>
      <source>Where the muons come from. gsf-sibyll (recommended): a table over altitude from 0 to 6000 m, zenith angle and energy, fitted to measured spectra, with its own error. The others are formulas for sea level that lie within 15 % of measured spectra only at the energies and zenith angles that Physics, and a warning, name.</source>
      <translation>De dónde vienen los muones. gsf-sibyll (recomendado): una tabla sobre altitud de 0 a 6000 m, ángulo cenital y energía, ajustada a espectros medidos, con su propio error. Los demás son fórmulas para el nivel del mar que quedan a menos de 15 % de los espectros medidos solo en las energías y los ángulos cenitales que nombran Física y una advertencia.</translation>
    </message>
    <message>
      <source>Parameters of the Gaisser formula</source>
      <translation>Parámetros de la fórmula de Gaisser</translation>
    </message>
    <message>
      <source>Constants of the formulas gaisser and gaisser-tang; the other models do not use them.</source>
      <translation>Constantes de las fórmulas gaisser y gaisser-tang; los demás modelos no las usan.</translation>
    </message>
    <message>
      <source>Energy loss</source>
      <translation>Pérdida de energía</translation>
    </message>
    <message>
      <source>csda: range table of the material (recommended). lesparre: polynomial for standard rock, up to 1 TeV. paper: energy over stopping power in place of the range, as in the first MUYSC; without answer beyond about 613 m of rock.</source>
      <translation>csda: tabla de alcances del material (recomendado). lesparre: polinomio para roca estándar, hasta 1 TeV. paper: energía dividida por el poder de frenado en lugar del alcance, como en el primer MUYSC; sin respuesta más allá de unos 613 m de roca.</translation>
    </message>
    <message>
      <source>Correct for straggling</source>
      <translation>Corregir las fluctuaciones de la pérdida</translation>
    </message>
    <message>
      <source>Whether to correct the flux for the fluctuations of the energy loss, which let more muons through thick rock than the mean loss does: 3 % more vertical ones at 1 km water equivalent, 13 % more at 3 km.</source>
      <translation>Si se corrige el flujo por las fluctuaciones de la pérdida de energía, que dejan pasar por la roca gruesa más muones que la pérdida media: un 3 % más de los verticales a 1 km equivalente de agua, un 13 % más a 3 km.</translation>
    </message>
    <message>
      <source>Correct for altitude</source>
      <translation>Corregir por altitud</translation>
    </message>
    <message>
      <source>Whether the flux of a formula grows with the altitude of the detector. Made for momenta above 10 GeV/c, altitudes below 1 km and zenith angles below 60°; beyond that a warning is given. With gsf-sibyll the altitude always counts.</source>
      <translation>Si el flujo de una fórmula crece con la altitud del detector. Hecha para momentos superiores a 10 GeV/c, altitudes inferiores a 1 km y ángulos cenitales inferiores a 60°; fuera de eso se da una advertencia. Con gsf-sibyll la altitud cuenta siempre.</translation>
    </message>
    <message>
      <source>Detection threshold (GeV, empty: 0.90, which is 1 GeV/c)</source>
      <translation>Umbral de detección (GeV, vacío: 0.90, que es 1 GeV/c)</translation>
    </message>
    <message>
      <source>Give the kinetic energy in GeV that a muon needs at the telescope to be detected, behind the rock and in the open sky alike, above 0 and below 100000. Empty stands for 0.90 GeV, which is p &gt; 1 GeV/c. With a formula for the flux, empty counts every muon behind rock and those above 1 GeV/c in the open sky, as earlier versions did.</source>
      <translation>Indique la energía cinética en GeV que un muon necesita en el telescopio para ser detectado, tanto detrás de la roca como en cielo abierto, mayor que 0 y menor que 100000. Vacío equivale a 0.90 GeV, que es p &gt; 1 GeV/c. Con una fórmula para el flujo, vacío cuenta todos los muones detrás de la roca y los de más de 1 GeV/c en cielo abierto, como hacían las versiones anteriores.</translation>
    </message>
    <message>
      <source>Opacity (g/cm²)</source>
      <translation>Opacidad (g/cm²)</translation>
    </message>
    <message>
      <source>Thickness times density, the mass per area that a muon has to cross. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Espesor por densidad, la masa por área que un muon tiene que atravesar. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Mean density (g/cm³)</source>
      <translation>Densidad media (g/cm³)</translation>
    </message>
    <message>
      <source>Mean density along each ray; a lower limit where no muon was counted. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Densidad media a lo largo de cada rayo; un límite inferior donde no se contó ningún muon. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Error of the mean density (g/cm³)</source>
      <translation>Error de la densidad media (g/cm³)</translation>
    </message>
    <message>
      <source>Standard error of the density, half of its interval. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Error estándar de la densidad, la mitad de su intervalo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Lower end of the mean density (g/cm³)</source>
      <translation>Extremo inferior de la densidad media (g/cm³)</translation>
    </message>
    <message>
      <source>Lower end of the interval of one standard deviation. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Extremo inferior del intervalo de una desviación estándar. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Upper end of the mean density (g/cm³)</source>
      <translation>Extremo superior de la densidad media (g/cm³)</translation>
    </message>
    <message>
      <source>Upper end of the interval of one standard deviation. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Extremo superior del intervalo de una desviación estándar. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Smallest mean density (g/cm³)</source>
      <translation>Menor densidad media (g/cm³)</translation>
    </message>
    <message>
      <source>Density with a flux one standard error of the model lower; with a formula, the smallest over those that hold for the ray. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Densidad con un flujo un error estándar del modelo menor; con una fórmula, la menor entre las que son válidas para el rayo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Largest mean density (g/cm³)</source>
      <translation>Mayor densidad media (g/cm³)</translation>
    </message>
    <message>
      <source>Density with a flux one standard error of the model higher; with a formula, the largest over those that hold for the ray. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Densidad con un flujo un error estándar del modelo mayor; con una fórmula, la mayor entre las que son válidas para el rayo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Flags of the mean density</source>
      <translation>Indicadores de la densidad media</translation>
    </message>
    <message>
      <source>0 measured, 1 no rock, 2 lower limit, 3 as bright as the open sky, 4 not measured, 5 no density explains the flux, 6 too little rock to dim it, 7 skyline or rock of many lengths in it. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>0 medido, 1 sin roca, 2 límite inferior, 3 tan brillante como el cielo abierto, 4 no medido, 5 ninguna densidad explica el flujo, 6 demasiado poca roca para atenuarlo, 7 perfil del horizonte o roca de muchas longitudes en él. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Regions of merged pixels</source>
      <translation>Regiones de píxeles unidos</translation>
    </message>
    <message>
      <source>Number of the region of merged pixels that shares one density, from 1. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Número de la región de píxeles unidos que comparte una densidad, desde 1. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Rock thickness (m)</source>
      <translation>Espesor de roca (m)</translation>
    </message>
    <message>
      <source>Length of each ray in rock, 0 in the sky. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Longitud de cada rayo en la roca, 0 en el cielo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Panel</source>
      <translation>Panel</translation>
    </message>
    <message>
      <source>Picture of density and its error side by side, with contours, skyline and target.</source>
      <translation>Figura de la densidad y su error lado a lado, con curvas de nivel, perfil del horizonte y objetivo.</translation>
    </message>
    <message>
      <source>Report</source>
      <translation>Informe</translation>
    </message>
    <message>
      <source>One HTML file with panels, map, parameters, numbers, every warning and how to cite.</source>
      <translation>Un archivo HTML con paneles, mapa, parámetros, números, todas las advertencias y cómo citar.</translation>
    </message>
    <message>
      <source>Part of it from counting (g/cm³)</source>
      <translation>Parte debida al conteo (g/cm³)</translation>
    </message>
    <message>
      <source>Median density (g/cm³)</source>
      <translation>Mediana de la densidad (g/cm³)</translation>
    </message>
    <message>
      <source>Pixels with rock</source>
      <translation>Píxeles con roca</translation>
    </message>
    <message>
      <source>Pixels with a density</source>
      <translation>Píxeles con una densidad</translation>
    </message>
    <message>
      <source>Pixels with a lower limit</source>
      <translation>Píxeles con un límite inferior</translation>
    </message>
    <message>
      <source>Pixels with rock as bright as the open sky</source>
      <translation>Píxeles con roca tan brillante como el cielo abierto</translation>
    </message>
    <message>
      <source>Pixels that cannot be known</source>
      <translation>Píxeles que no se pueden conocer</translation>
    </message>
    <message>
      <source>Regions with a density of their own</source>
      <translation>Regiones con densidad propia</translation>
    </message>
    <message>
      <source>Pixels of which one ray says too little</source>
      <translation>Píxeles de los que un rayo dice demasiado poco</translation>
    </message>
    <message>
      <source>Scatter of the densities about their mean (χ² per datum)</source>
      <translation>Dispersión de las densidades en torno a su media (χ² por dato)</translation>
    </message>
    <message>
      <source>Open sky seen over what the flux model promises</source>
      <translation>Cielo abierto visto sobre lo que promete el modelo de flujo</translation>
    </message>
    <message>
      <source>Download SRTM topography</source>
      <translation>Descargar topografía SRTM</translation>
    </message>
    <message>
      <source>Terrain</source>
      <translation>Terreno</translation>
    </message>
    <message>
      <source>&lt;p&gt;Makes the elevation model of an extent from public tiles of one degree: heights in m, in longitude and latitude, cell for cell as the tiles have them.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Compone el modelo de elevación de una extensión a partir de teselas públicas de un grado: alturas en m, en longitud y latitud, celda por celda tal como las tienen las teselas.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;The extent must hold the detector, the target and all rock behind it; a &lt;b&gt;margin&lt;/b&gt; widens it. Tiles come from the &lt;b&gt;source&lt;/b&gt;: &lt;i&gt;srtm&lt;/i&gt; (radar heights of 2000, 56° south to 60° north), &lt;i&gt;copernicus&lt;/i&gt; (GLO-30, 2011 to 2015, the surface with trees and buildings), or an address of your own. The log says how to name the source, and the raster keeps it.&lt;/p&gt;</source>
      <translation>&lt;p&gt;La extensión debe contener el detector, el objetivo y toda la roca detrás de él; un &lt;b&gt;margen&lt;/b&gt; la ensancha. Las teselas vienen de la &lt;b&gt;fuente&lt;/b&gt;: &lt;i&gt;srtm&lt;/i&gt; (alturas de radar de 2000, de 56° sur a 60° norte), &lt;i&gt;copernicus&lt;/i&gt; (GLO-30, de 2011 a 2015, la superficie con árboles y edificios), o una dirección propia. El registro dice cómo citar la fuente, y el ráster lo conserva.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;Every tile is checked and kept in a folder, so that a run that was stopped goes on where it was and the next one needs no network. What comes is limited in number and size. The proxy, timeout and authentications of QGIS count.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Cada tesela se comprueba y se guarda en una carpeta, de modo que una ejecución interrumpida continúa donde quedó y la siguiente no necesita red. Lo que llega está limitado en número y tamaño. Cuentan el proxy, el tiempo de espera y las autenticaciones de QGIS.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;A tile that the server does not have is taken as sea level, and the log says so. &lt;b&gt;Cells without a height&lt;/b&gt; have no data, are counted, and are filled from their neighbours on request. The default source holds the depths of the sea floor too.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Una tesela que el servidor no tiene se toma como nivel del mar, y el registro lo dice. Las &lt;b&gt;celdas sin altura&lt;/b&gt; quedan sin dato, se cuentan y, si se pide, se rellenan con sus vecinas. La fuente predeterminada contiene también las profundidades del fondo marino.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;One arc second, about 30 m, smooths crater rims by tens of metres.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Un segundo de arco, unos 30 m, suaviza los bordes de los cráteres en decenas de metros.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Extent</source>
      <translation>Extensión</translation>
    </message>
    <message>
      <source>Part of the map, in any coordinate reference system: detector, target and all rock behind it. As text: xmin,xmax,ymin,ymax [EPSG:code]; without a code and a project longitudes and latitudes.</source>
      <translation>Parte del mapa, en cualquier sistema de referencia de coordenadas: detector, objetivo y toda la roca detrás de él. Como texto: xmin,xmax,ymin,ymax [EPSG:code]; sin código ni proyecto, longitudes y latitudes.</translation>
    </message>
    <message>
      <source>Margin (m)</source>
      <translation>Margen (m)</translation>
    </message>
    <message>
      <source>Give the width of the strip added around the extent in m, 0 to 100000.</source>
      <translation>Indique el ancho en m de la franja que se agrega alrededor de la extensión, de 0 a 100000.</translation>
    </message>
    <message>
      <source>Source of the tiles</source>
      <translation>Fuente de las teselas</translation>
    </message>
    <message>
      <source>srtm: public Terrain Tiles, one arc second. copernicus: Copernicus GLO-30, one arc second, surface with trees and buildings. Or the address of tiles on https:// or file://, such as https://server/{latitude}/{tile}.hgt.gz, where {tile} stands for N40E014, {latitude} for N40 and {longitude} for E014; plain, gzipped and zipped .hgt and GeoTIFF. The setting muysc/srtm_source changes the default.</source>
      <translation>srtm: Terrain Tiles públicas, un segundo de arco. copernicus: Copernicus GLO-30, un segundo de arco, superficie con árboles y edificios. O la dirección de teselas en https:// o file://, como https://server/{latitude}/{tile}.hgt.gz, donde {tile} representa N40E014, {latitude} N40 y {longitude} E014; .hgt sin comprimir, en gzip o zip, y GeoTIFF. El ajuste muysc/srtm_source cambia el valor predeterminado.</translation>
    </message>
    <message>
      <source>Fill cells without a height</source>
      <translation>Rellenar las celdas sin altura</translation>
    </message>
    <message>
      <source>Whether cells without a height take that of their neighbours, weighted by the inverse of the distance.</source>
      <translation>Si las celdas sin altura toman la de sus vecinas, ponderada por el inverso de la distancia.</translation>
    </message>
    <message>
      <source>How far to look for heights (cells)</source>
      <translation>Hasta dónde buscar alturas (celdas)</translation>
    </message>
    <message>
      <source>Give the distance at which voids are still filled in cells, a whole number from 1 to 1000; one cell is about 30 m.</source>
      <translation>Indique la distancia en celdas a la que aún se rellenan vacíos, un número entero de 1 a 1000; una celda mide unos 30 m.</translation>
    </message>
    <message>
      <source>Largest number of tiles</source>
      <translation>Número máximo de teselas</translation>
    </message>
    <message>
      <source>Give the number of tiles of one degree that may be downloaded, a whole number from 1 to 200. One has about 10 MB from srtm and 40 MB from copernicus.</source>
      <translation>Indique el número de teselas de un grado que se pueden descargar, un número entero de 1 a 200. Una ocupa unos 10 MB en srtm y 40 MB en copernicus.</translation>
    </message>
    <message>
      <source>Authentication</source>
      <translation>Autenticación</translation>
    </message>
    <message>
      <source>Authentication configuration of QGIS, for servers that ask for a login.</source>
      <translation>Configuración de autenticación de QGIS, para servidores que piden identificarse.</translation>
    </message>
    <message>
      <source>Timeout (s, empty: that of QGIS)</source>
      <translation>Tiempo de espera (s, vacío: el de QGIS)</translation>
    </message>
    <message>
      <source>Give the seconds without a byte after which an attempt ends, 0.1 to 600.</source>
      <translation>Indique los segundos sin recibir un byte tras los cuales termina un intento, de 0.1 a 600.</translation>
    </message>
    <message>
      <source>Further attempts</source>
      <translation>Intentos adicionales</translation>
    </message>
    <message>
      <source>Give the number of further attempts after a timeout or a fault of the server, a whole number from 0 to 10; the pauses between them grow.</source>
      <translation>Indique el número de intentos adicionales tras una espera agotada o un fallo del servidor, un número entero de 0 a 10; las pausas entre ellos crecen.</translation>
    </message>
    <message>
      <source>Folder of kept tiles (empty: in the profile)</source>
      <translation>Carpeta de teselas guardadas (vacío: en el perfil)</translation>
    </message>
    <message>
      <source>Folder where tiles are kept and looked for; several runs may share it. Empty: cache/muysc in the profile of QGIS.</source>
      <translation>Carpeta donde se guardan y se buscan las teselas; varias ejecuciones pueden compartirla. Vacío: cache/muysc en el perfil de QGIS.</translation>
    </message>
    <message>
      <source>Elevation model</source>
      <translation>Modelo de elevación</translation>
    </message>
    <message>
      <source>GeoTIFF of heights in m in longitude and latitude (EPSG:4326), cell for cell as in the tiles; cells without a height have no data.</source>
      <translation>GeoTIFF de alturas en m en longitud y latitud (EPSG:4326), celda por celda como en las teselas; las celdas sin altura quedan sin dato.</translation>
    </message>
    <message>
      <source>Tiles</source>
      <translation>Teselas</translation>
    </message>
    <message>
      <source>Tiles from the cache</source>
      <translation>Teselas tomadas de la carpeta</translation>
    </message>
    <message>
      <source>Tiles taken as sea level</source>
      <translation>Teselas tomadas como nivel del mar</translation>
    </message>
    <message>
      <source>Cells without a height</source>
      <translation>Celdas sin altura</translation>
    </message>
    <message>
      <source>Cells that were filled</source>
      <translation>Celdas rellenadas</translation>
    </message>
    <message>
      <source>Drape muogram on the terrain</source>
      <translation>Proyectar muograma sobre el terreno</translation>
    </message>
    <message>
      <source>&lt;p&gt;Puts a muogram back on the map: each cell of the elevation model that the detector sees carries the muogram's value in that direction, on the grid and in the coordinate reference system of the elevation model.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Devuelve un muograma al mapa: cada celda del modelo de elevación que ve el detector lleva el valor del muograma en esa dirección, en la rejilla y el sistema de referencia de coordenadas del modelo de elevación.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;The &lt;b&gt;near&lt;/b&gt; side is the rock face towards the detector, where rays enter the first rock; the &lt;b&gt;far&lt;/b&gt; side is where they leave the last. Cells that are hidden or outside the field of view have no data.&lt;/p&gt;</source>
      <translation>&lt;p&gt;El lado &lt;b&gt;near&lt;/b&gt; (cercano) es la cara de la roca hacia el detector, por donde los rayos entran en la primera roca; el lado &lt;b&gt;far&lt;/b&gt; (lejano) es por donde salen de la última. Las celdas ocultas o fuera del campo de visión quedan sin dato.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;The muogram says itself where its detector stands. The elevation model must contain the detector; it should be the one the muogram was made from, or a better one of the same place.&lt;/p&gt;</source>
      <translation>&lt;p&gt;El propio muograma dice dónde está su detector. El modelo de elevación debe contener el detector; conviene que sea el mismo con el que se hizo el muograma, o uno mejor del mismo lugar.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Muogram</source>
      <translation>Muograma</translation>
    </message>
    <message>
      <source>Muogram of any quantity, or raster of expected counts in telescope angles; it says itself where its detector stands.</source>
      <translation>Muograma de cualquier magnitud, o ráster de conteos esperados en ángulos del telescopio; él mismo dice dónde está su detector.</translation>
    </message>
    <message>
      <source>Raster of terrain heights, in any coordinate reference system. It must hold the detector, the target and all rock behind it. Cells without data count as unknown.</source>
      <translation>Ráster de alturas del terreno, en cualquier sistema de referencia de coordenadas. Debe contener el detector, el objetivo y toda la roca detrás de él. Las celdas sin dato cuentan como desconocidas.</translation>
    </message>
    <message>
      <source>Side of the rock</source>
      <translation>Lado de la roca</translation>
    </message>
    <message>
      <source>near: the face towards the detector, where rays enter the first rock. far: the face away from it, where rays leave the last rock.</source>
      <translation>near: la cara hacia el detector, por donde los rayos entran en la primera roca. far: la cara opuesta, por donde los rayos salen de la última roca.</translation>
    </message>
    <message>
      <source>Draped muogram</source>
      <translation>Muograma sobre el terreno</translation>
    </message>
    <message>
      <source>GeoTIFF on the grid and in the coordinate reference system of the DEM; cells that the detector does not see have no data.</source>
      <translation>GeoTIFF en la rejilla y el sistema de referencia de coordenadas del MDE; las celdas que el detector no ve quedan sin dato.</translation>
    </message>
    <message>
      <source>Cells with a value</source>
      <translation>Celdas con un valor</translation>
    </message>
    <message>
      <source>Expected counts in a telescope</source>
      <translation>Conteos esperados en un telescopio</translation>
    </message>
    <message>
      <source>Telescope</source>
      <translation>Telescopio</translation>
    </message>
    <message>
      <source>&lt;p&gt;Computes how many muons a telescope counts behind a mountain along each of its trajectories, how precise the counts are, which density contrasts they show, and how many days that takes.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Calcula cuántos muones cuenta un telescopio detrás de una montaña a lo largo de cada una de sus trayectorias, con qué precisión, qué contrastes de densidad muestran los conteos y cuántos días hacen falta.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose an elevation model, click where the telescope stands and what it points at, choose the telescope and the days of counting, and run. Azimuth, elevation and roll of the telescope can be given too.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Cómo se usa.&lt;/b&gt; Elija un modelo de elevación, haga clic donde está el telescopio y en aquello a lo que apunta, elija el telescopio y los días de conteo, y ejecute. También se pueden indicar azimut, elevación y giro del telescopio.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; The flux is that of &lt;i&gt;Muon radiography&lt;/i&gt;. Its mean over all directions that belong to a trajectory, rock and sky at the skyline alike, times the acceptance and the days gives the counts; the share of it behind rock is a raster too. The mean is a sum over as many rays as the counts call for, and its error is told. The smallest visible contrast is the decrease of the mean density along the whole path whose counts chance would reach with the probability of the significance given; the days for a contrast follow from the same exact Poisson law, or from the feasibility formula of Lesparre et al. (2010).&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué hace.&lt;/b&gt; El flujo es el de &lt;i&gt;Radiografía de muones&lt;/i&gt;. Su media sobre todas las direcciones que pertenecen a una trayectoria, roca y cielo por igual en el perfil del horizonte, por la aceptancia y los días da los conteos; la parte que está detrás de roca es también un ráster. La media es una suma sobre tantos rayos como piden los conteos, y se dice su error. El menor contraste visible es la disminución de la densidad media a lo largo de todo el recorrido cuyos conteos alcanzaría el azar con la probabilidad de la significación indicada; los días para un contraste se siguen de la misma ley exacta de Poisson, o de la fórmula de viabilidad de Lesparre et al. (2010).&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does not know&lt;/b&gt; has no data, never 0, and is counted in the log by cause: trajectories that look, in part, at or below the horizon, or along which the rock is unknown.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Lo que no se conoce&lt;/b&gt; queda sin dato, nunca 0, y se cuenta en el registro según la causa: trayectorias que miran, en parte, al horizonte o por debajo, o a lo largo de las cuales la roca es desconocida.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;The rasters&lt;/b&gt; have the tangent of the angle from the boresight as axes, the telescope's right as x and its up as y; boresight and roll in their metadata lead to azimuth and elevation, and the table lists them.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Los rásteres&lt;/b&gt; tienen como ejes la tangente del ángulo desde el eje del telescopio, con su derecha como x y su arriba como y; el eje y el giro en los metadatos conducen a azimut y elevación, y la tabla los enumera.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Merging&lt;/b&gt; takes an odd number of trajectories together across and up: less detail in less time.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Agrupar&lt;/b&gt; reúne un número impar de trayectorias a lo ancho y a lo alto: menos detalle en menos tiempo.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Detector</source>
      <translation>Detector</translation>
    </message>
    <message>
      <source>Where the telescope stands, on the DEM. As text: x,y [EPSG:code]; without a code the point is in the project's CRS, or the DEM's where there is no project.</source>
      <translation>Dónde está el telescopio, sobre el MDE. Como texto: x,y [EPSG:code]; sin código el punto está en el SRC del proyecto, o en el del MDE si no hay proyecto.</translation>
    </message>
    <message>
      <source>Detector height above ground (m)</source>
      <translation>Altura del detector sobre el suelo (m)</translation>
    </message>
    <message>
      <source>Give the height of the telescope above the ground in m, −10000 to 10000; negative in a tunnel or borehole.</source>
      <translation>Indique la altura del telescopio sobre el suelo en m, de −10000 a 10000; negativa en un túnel o una perforación.</translation>
    </message>
    <message>
      <source>Target</source>
      <translation>Objetivo</translation>
    </message>
    <message>
      <source>What the telescope points at, on the DEM: the middle of the field of view.</source>
      <translation>A qué apunta el telescopio, sobre el MDE: el centro del campo de visión.</translation>
    </message>
    <message>
      <source>Target height above ground (m)</source>
      <translation>Altura del objetivo sobre el suelo (m)</translation>
    </message>
    <message>
      <source>Give the height of the aiming point above the ground in m, −10000 to 10000; negative inside the mountain.</source>
      <translation>Indique la altura del punto de mira sobre el suelo en m, de −10000 a 10000; negativa dentro de la montaña.</translation>
    </message>
    <message>
      <source>A telescope that was built, or custom for the numbers below. A preset wins over numbers, and the log says which were not used. mute: 30 × 30 bars of 4 cm, 250 cm; gibert2010: 32 × 32 bars of 5 cm, 100 cm; carbone2014: 16 × 16 bars of 5 cm, 170 cm; lopresti2020: 99 × 99 bars of 1 cm, 97 cm; lesparre2012: 16 × 16 bars of 5 cm, 115 cm; lesparre2010: 16 × 16 bars of 5 cm, 80 cm; uchida2009: 12 × 12 bars of 7 cm, 100 cm; muraves: 60 × 60 bars of 3.4 cm, 200 cm.</source>
      <translation>Un telescopio que se construyó, o custom para los números de abajo. Un telescopio de la lista prevalece sobre los números, y el registro dice cuáles no se usaron. mute: 30 × 30 barras de 4 cm, 250 cm; gibert2010: 32 × 32 barras de 5 cm, 100 cm; carbone2014: 16 × 16 barras de 5 cm, 170 cm; lopresti2020: 99 × 99 barras de 1 cm, 97 cm; lesparre2012: 16 × 16 barras de 5 cm, 115 cm; lesparre2010: 16 × 16 barras de 5 cm, 80 cm; uchida2009: 12 × 12 barras de 7 cm, 100 cm; muraves: 60 × 60 barras de 3.4 cm, 200 cm.</translation>
    </message>
    <message>
      <source>Bars across (custom telescope)</source>
      <translation>Barras a lo ancho (telescopio custom)</translation>
    </message>
    <message>
      <source>Give the number of bars side by side, 1 to 1000.</source>
      <translation>Indique el número de barras una al lado de otra, de 1 a 1000.</translation>
    </message>
    <message>
      <source>Bars up (empty: as many as across)</source>
      <translation>Barras a lo alto (vacío: tantas como a lo ancho)</translation>
    </message>
    <message>
      <source>Give the number of bars one above another, 1 to 1000.</source>
      <translation>Indique el número de barras una encima de otra, de 1 a 1000.</translation>
    </message>
    <message>
      <source>Width of a bar (cm, custom telescope)</source>
      <translation>Ancho de una barra (cm, telescopio custom)</translation>
    </message>
    <message>
      <source>Give the width of a bar in cm, above 0: the side of a pixel.</source>
      <translation>Indique el ancho de una barra en cm, mayor que 0: el lado de un píxel.</translation>
    </message>
    <message>
      <source>Separation of the planes (cm, custom telescope)</source>
      <translation>Separación de los planos (cm, telescopio custom)</translation>
    </message>
    <message>
      <source>Give the distance between the front and the back plane in cm, above 0.</source>
      <translation>Indique la distancia entre el plano delantero y el trasero en cm, mayor que 0.</translation>
    </message>
    <message>
      <source>Planes (empty: 2)</source>
      <translation>Planos (vacío: 2)</translation>
    </message>
    <message>
      <source>Give the number of planes, 2 to 20, the outer two included. Those in between change neither directions nor acceptance: a straight track through the outer ones crosses them too. They are drawn.</source>
      <translation>Indique el número de planos, de 2 a 20, incluidos los dos exteriores. Los intermedios no cambian ni las direcciones ni la aceptancia: una traza recta que pasa por los exteriores también los cruza. Se dibujan.</translation>
    </message>
    <message>
      <source>Acceptance formula</source>
      <translation>Fórmula de la aceptancia</translation>
    </message>
    <message>
      <source>exact: full integral over two pixels. paper: pixel area squared over the squared distance, as MUYSC was published; it leaves out the obliquity of the planes and is too high at large angles, by 7 % to 47 % in total.</source>
      <translation>exact: integral completa sobre dos píxeles. paper: área del píxel al cuadrado dividida por el cuadrado de la distancia, como se publicó MUYSC; omite la oblicuidad de los planos y resulta demasiado alta a ángulos grandes, entre 7 % y 47 % en total.</translation>
    </message>
    <message>
      <source>Boresight azimuth (°, empty: towards the target)</source>
      <translation>Azimut del eje (°, vacío: hacia el objetivo)</translation>
    </message>
    <message>
      <source>Give the azimuth of the telescope's axis in degrees clockwise from true north, −360 to 360. Empty points at the target.</source>
      <translation>Indique el azimut del eje del telescopio en grados en sentido horario desde el norte verdadero, de −360 a 360. Vacío apunta al objetivo.</translation>
    </message>
    <message>
      <source>Boresight elevation (°, empty: towards the target)</source>
      <translation>Elevación del eje (°, vacío: hacia el objetivo)</translation>
    </message>
    <message>
      <source>Give the elevation of the telescope's axis above the horizontal in degrees, −90 to 90. Empty points at the target.</source>
      <translation>Indique la elevación del eje del telescopio sobre la horizontal en grados, de −90 a 90. Vacío apunta al objetivo.</translation>
    </message>
    <message>
      <source>Roll (°)</source>
      <translation>Giro (°)</translation>
    </message>
    <message>
      <source>Give the angle in degrees, −360 to 360, by which the telescope is turned clockwise about its axis, seen looking along it. With 0 its bars are level.</source>
      <translation>Indique el ángulo en grados, de −360 a 360, que el telescopio está girado en sentido horario alrededor de su eje, mirando a lo largo de él. Con 0 sus barras están niveladas.</translation>
    </message>
    <message>
      <source>Days of counting (days)</source>
      <translation>Días de conteo (días)</translation>
    </message>
    <message>
      <source>Give the time of counting in days, above 0.</source>
      <translation>Indique el tiempo de conteo en días, mayor que 0.</translation>
    </message>
    <message>
      <source>Muons along a trajectory</source>
      <translation>Muones por trayectoria</translation>
    </message>
    <message>
      <source>Give the number of muons wanted along each trajectory, above 0, for the exposure time. 10 muons give the flux to about 32 %, 100 to 10 %.</source>
      <translation>Indique el número de muones deseado en cada trayectoria, mayor que 0, para el tiempo de exposición. 10 muones dan el flujo con un 32 % aproximadamente, 100 con un 10 %.</translation>
    </message>
    <message>
      <source>Significance (standard deviations)</source>
      <translation>Significación (desviaciones estándar)</translation>
    </message>
    <message>
      <source>Give the significance in standard deviations with which a contrast is to be seen, above 0 and up to 30; one-sided.</source>
      <translation>Indique la significación en desviaciones estándar con que debe verse un contraste, mayor que 0 y hasta 30; unilateral.</translation>
    </message>
    <message>
      <source>Density contrast to see (%)</source>
      <translation>Contraste de densidad por ver (%)</translation>
    </message>
    <message>
      <source>Give the change of the mean density along the whole path in percent, above −100 and not 0: −10 for rock that is 10 % lighter.</source>
      <translation>Indique el cambio de la densidad media a lo largo de todo el camino en porcentaje, mayor que −100 y distinto de 0: −10 para roca un 10 % más ligera.</translation>
    </message>
    <message>
      <source>Trajectories merged along a side</source>
      <translation>Trayectorias agrupadas por lado</translation>
    </message>
    <message>
      <source>Give an odd number of trajectories to take together across and up, from 1: larger bins count more muons and see less detail.</source>
      <translation>Indique un número impar de trayectorias que se reúnen a lo ancho y a lo alto, desde 1: las celdas más grandes cuentan más muones y ven menos detalle.</translation>
    </message>
    <message>
      <source>Efficiency</source>
      <translation>Eficiencia</translation>
    </message>
    <message>
      <source>Give the share of the muons through all planes that is recorded, above 0 and up to 1.</source>
      <translation>Indique la fracción de los muones que atraviesan todos los planos que se registra, mayor que 0 y hasta 1.</translation>
    </message>
    <message>
      <source>Statistics of the contrast</source>
      <translation>Estadística del contraste</translation>
    </message>
    <message>
      <source>poisson: exact, for few counts as for many. lesparre: the feasibility formula of Lesparre et al. (2010), for many counts. They agree from about a hundred counts.</source>
      <translation>poisson: exacta, tanto para pocos conteos como para muchos. lesparre: la fórmula de factibilidad de Lesparre et al. (2010), para muchos conteos. Coinciden a partir de unos cien conteos.</translation>
    </message>
    <message>
      <source>Rays for each bar</source>
      <translation>Rayos por barra</translation>
    </message>
    <message>
      <source>Give the number of rays along a side, 1 to 50, for each step from one trajectory to the next. Errors fall with its square; where they matter beside those of counting, up to four times as many are traced.</source>
      <translation>Indique el número de rayos por lado, de 1 a 50, para cada paso de una trayectoria a la siguiente. Los errores disminuyen con su cuadrado; donde importan junto a los de conteo, se trazan hasta cuatro veces más.</translation>
    </message>
    <message>
      <source>Error of the terrain (m)</source>
      <translation>Error del terreno (m)</translation>
    </message>
    <message>
      <source>Give the standard error of the terrain's heights on the mountain in m, 0 to 1000: 1.48 times the median of their deviations from a better model. Only for THICKNESS_ERROR.</source>
      <translation>Indique el error estándar de las alturas del terreno en la montaña en m, de 0 a 1000: 1.48 veces la mediana de sus desviaciones respecto a un modelo mejor. Solo para THICKNESS_ERROR.</translation>
    </message>
    <message>
      <source>Terrain errors are alike within (m)</source>
      <translation>Los errores del terreno son iguales dentro de (m)</translation>
    </message>
    <message>
      <source>Give the distance in m within which heights of the terrain are wrong alike, 0 to 100000. Over wider trajectories their errors average out, and nearer to the detector they make no difference. Only for THICKNESS_ERROR.</source>
      <translation>Indique la distancia en m dentro de la cual las alturas del terreno se equivocan por igual, de 0 a 100000. En trayectorias más anchas sus errores se promedian, y más cerca del detector no importan. Solo para THICKNESS_ERROR.</translation>
    </message>
    <message>
      <source>Error of the pointing (°)</source>
      <translation>Error del apuntado (°)</translation>
    </message>
    <message>
      <source>Give the standard error of the elevation angle that the telescope points at in degrees, 0 to 30. Only for THICKNESS_ERROR.</source>
      <translation>Indique el error estándar del ángulo de elevación al que apunta el telescopio en grados, de 0 a 30. Solo para THICKNESS_ERROR.</translation>
    </message>
    <message>
      <source>Density (g/cm³, empty: the material's own)</source>
      <translation>Densidad (g/cm³, vacío: la del material)</translation>
    </message>
    <message>
      <source>Give the mean density in g/cm³, above 0 and up to 30. Empty stands for the material's own: standard_rock 2.65, water 1, ice 0.918, limestone 2.71, dolomite 2.87, quartzite 2.65, granite 2.64, granodiorite 2.73, diorite 2.85, andesite 2.61, basalt 2.99, gabbro 3.03, concrete 2.3.</source>
      <translation>Indique la densidad media en g/cm³, mayor que 0 y hasta 30. Vacío representa la propia del material: standard_rock 2.65, water 1, ice 0.918, limestone 2.71, dolomite 2.87, quartzite 2.65, granite 2.64, granodiorite 2.73, diorite 2.85, andesite 2.61, basalt 2.99, gabbro 3.03, concrete 2.3.</translation>
    </message>
    <message>
      <source>Maximum range (m, empty: as far as the DEM)</source>
      <translation>Alcance máximo (m, vacío: hasta donde llegue el MDE)</translation>
    </message>
    <message>
      <source>Give the largest horizontal distance in m at which rock counts, above 0. Rays still in rock there keep the thickness up to it. Empty looks as far as the DEM reaches.</source>
      <translation>Indique la mayor distancia horizontal en m a la que cuenta la roca, mayor que 0. Los rayos que allí siguen en roca conservan el espesor hasta ese punto. Vacío mira hasta donde llegue el MDE.</translation>
    </message>
    <message>
      <source>Near field to ignore (m)</source>
      <translation>Campo cercano que se ignora (m)</translation>
    </message>
    <message>
      <source>Give the distance in m within which terrain is ignored, 0 or more: for small bumps at the detector's foot that a DEM cannot resolve.</source>
      <translation>Indique la distancia en m dentro de la cual se ignora el terreno, 0 o más: para pequeños resaltes al pie del detector que un MDE no puede resolver.</translation>
    </message>
    <message>
      <source>Muons expected along each trajectory in the time given. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Muones esperados a lo largo de cada trayectoria en el tiempo indicado. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Exposure time (days)</source>
      <translation>Tiempo de exposición (días)</translation>
    </message>
    <message>
      <source>Days until a pixel has counted the muons wanted. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Días hasta que un píxel ha contado los muones deseados. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Counting error (%)</source>
      <translation>Error de conteo (%)</translation>
    </message>
    <message>
      <source>Standard error of the counts, in percent of them. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Error estándar de los conteos, en porcentaje de ellos. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Smallest visible density contrast (%)</source>
      <translation>Menor contraste de densidad visible (%)</translation>
    </message>
    <message>
      <source>Smallest decrease of the mean density along the path that the counts show, in percent. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Menor disminución de la densidad media a lo largo del camino que muestran los conteos, en porcentaje. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Days to see the density contrast (days)</source>
      <translation>Días para ver el contraste de densidad (días)</translation>
    </message>
    <message>
      <source>Days until the density contrast shows. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Días hasta que se muestra el contraste de densidad. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Open-sky muon counts</source>
      <translation>Conteos de muones a cielo abierto</translation>
    </message>
    <message>
      <source>Muons that there would be without the rock. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Muones que habría sin la roca. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Muon flux (cm⁻² sr⁻¹ day⁻¹)</source>
      <translation>Flujo de muones (cm⁻² sr⁻¹ day⁻¹)</translation>
    </message>
    <message>
      <source>Integral flux of the muons that get through. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Flujo integral de los muones que logran pasar. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Length of each ray in rock, 0 in the sky. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Longitud de cada rayo en la roca, 0 en el cielo. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Share of the response behind rock</source>
      <translation>Parte de la respuesta detrás de roca</translation>
    </message>
    <message>
      <source>Share of each trajectory's response that lies behind rock, 0 to 1. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Parte de la respuesta de cada trayectoria que está detrás de roca, de 0 a 1. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Acceptance (cm² sr)</source>
      <translation>Aceptancia (cm² sr)</translation>
    </message>
    <message>
      <source>Counts per time are the acceptance times the flux. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Los conteos por tiempo son la aceptancia por el flujo. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Error of the rock thickness (m)</source>
      <translation>Error del espesor de roca (m)</translation>
    </message>
    <message>
      <source>Standard error of the thickness from those of terrain and pointing. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Error estándar del espesor a partir de los del terreno y del apuntado. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Table of trajectories</source>
      <translation>Tabla de trayectorias</translation>
    </message>
    <message>
      <source>CSV with a row for each trajectory and units in the header.</source>
      <translation>CSV con una fila por trayectoria y las unidades en el encabezado.</translation>
    </message>
    <message>
      <source>Picture of the counts on the mountain with skyline, horizon and target, beside the counting error, the contrast that can be seen and the days that it takes.</source>
      <translation>Figura de los conteos sobre la montaña con perfil del horizonte, horizonte y objetivo, junto al error de conteo, el contraste que se puede ver y los días que hacen falta.</translation>
    </message>
    <message>
      <source>Muons along all known trajectories (per day)</source>
      <translation>Muones en todas las trayectorias conocidas (por día)</translation>
    </message>
    <message>
      <source>Muons along trajectories behind rock (per day)</source>
      <translation>Muones en trayectorias detrás de la roca (por día)</translation>
    </message>
    <message>
      <source>Median counts behind rock</source>
      <translation>Mediana de los conteos detrás de la roca</translation>
    </message>
    <message>
      <source>Median exposure behind rock (days)</source>
      <translation>Mediana de la exposición detrás de la roca (días)</translation>
    </message>
    <message>
      <source>Median of the smallest visible contrast (%)</source>
      <translation>Mediana del menor contraste visible (%)</translation>
    </message>
    <message>
      <source>Median time to see the contrast (days)</source>
      <translation>Mediana del tiempo para ver el contraste (días)</translation>
    </message>
    <message>
      <source>Trajectories or bins of them</source>
      <translation>Trayectorias o grupos de ellas</translation>
    </message>
    <message>
      <source>Trajectories behind rock</source>
      <translation>Trayectorias detrás de la roca</translation>
    </message>
    <message>
      <source>Trajectories without counts</source>
      <translation>Trayectorias sin conteos</translation>
    </message>
    <message>
      <source>Error of the sums over sub-rays (counting errors)</source>
      <translation>Error de las sumas sobre subrayos (errores de conteo)</translation>
    </message>
    <message>
      <source>Boresight azimuth (°)</source>
      <translation>Azimut del eje (°)</translation>
    </message>
    <message>
      <source>Boresight elevation (°)</source>
      <translation>Elevación del eje (°)</translation>
    </message>
    <message>
      <source>Detector elevation (m)</source>
      <translation>Elevación del detector (m)</translation>
    </message>
    <message>
      <source>Target distance (m)</source>
      <translation>Distancia al objetivo (m)</translation>
    </message>
    <message>
      <source>Exposure plan</source>
      <translation>Plan de exposición</translation>
    </message>
    <message>
      <source>Models</source>
      <translation>Modelos</translation>
    </message>
    <message>
      <source>&lt;p&gt;Answers how long a telescope has to count: expected counts, days of exposure and the smallest visible density contrast along its trajectories, and the last two draped on the terrain that it sees.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Responde cuánto tiempo tiene que contar un telescopio: conteos esperados, días de exposición y menor contraste de densidad visible a lo largo de sus trayectorias, y los dos últimos proyectados sobre el terreno que ve.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Smallest visible contrast on the terrain</source>
      <translation>Menor contraste visible sobre el terreno</translation>
    </message>
    <message>
      <source>Exposure time on the terrain</source>
      <translation>Tiempo de exposición sobre el terreno</translation>
    </message>
    <message>
      <source>Smallest visible density contrast</source>
      <translation>Menor contraste de densidad visible</translation>
    </message>
    <message>
      <source>Exposure time</source>
      <translation>Tiempo de exposición</translation>
    </message>
    <message>
      <source>Compare muon spectra</source>
      <translation>Comparar espectros de muones</translation>
    </message>
    <message>
      <source>&lt;p&gt;Draws and tabulates muon flux models side by side: the differential spectra at chosen zenith angles, the energy loss of muons in several materials, the energy that rock demands, and the transmission and flux that are left behind it.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Dibuja y tabula modelos de flujo de muones lado a lado: los espectros diferenciales a los ángulos cenitales elegidos, la pérdida de energía de los muones en varios materiales, la energía que exige la roca, y la transmisión y el flujo que quedan detrás de ella.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;Use it to choose a model for a site, to see how far the models lie apart there, and to find where each was made for: lines are faded outside a model's range of energies and angles, and the tables say so point by point. &lt;i&gt;Thickness&lt;/i&gt; and &lt;i&gt;Material&lt;/i&gt; set the amount of rock that the figures mark; the area shaded under the spectrum are the muons that get through it.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Sirve para elegir un modelo para un sitio, ver cuánto difieren allí los modelos y saber para qué se hizo cada uno: las líneas se atenúan fuera del intervalo de energías y ángulos de un modelo, y las tablas lo dicen punto por punto. &lt;i&gt;Espesor&lt;/i&gt; y &lt;i&gt;Material&lt;/i&gt; fijan la cantidad de roca que marcan las figuras; el área sombreada bajo el espectro son los muones que la atraviesan.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;The physics is that of &lt;i&gt;Muon radiography&lt;/i&gt;: the flux at an opacity is the one that a pixel with that opacity has.&lt;/p&gt;</source>
      <translation>&lt;p&gt;La física es la de &lt;i&gt;Radiografía de muones&lt;/i&gt;: el flujo a una opacidad es el que tiene un píxel con esa opacidad.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;Tables are CSV files with the unit in each column's name; what has no answer is left empty.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Las tablas son archivos CSV con la unidad en el nombre de cada columna; lo que no tiene respuesta queda vacío.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Muon flux models</source>
      <translation>Modelos de flujo de muones</translation>
    </message>
    <message>
      <source>Parametrised spectra to compare.</source>
      <translation>Espectros parametrizados que se comparan.</translation>
    </message>
    <message>
      <source>Zenith angles (°)</source>
      <translation>Ángulos cenitales (°)</translation>
    </message>
    <message>
      <source>List zenith angles in degrees, from 0 (overhead) to below 90, separated by commas; at most 12.</source>
      <translation>Enumere ángulos cenitales en grados, desde 0 (la vertical) hasta menos de 90, separados por comas; a lo sumo 12.</translation>
    </message>
    <message>
      <source>Thickness of rock (m)</source>
      <translation>Espesor de roca (m)</translation>
    </message>
    <message>
      <source>Give the thickness of rock in m that the figures mark, above 0 and up to 20000.</source>
      <translation>Indique el espesor de roca en m que marcan las figuras, mayor que 0 y hasta 20000.</translation>
    </message>
    <message>
      <source>Altitude of the detector (m)</source>
      <translation>Altitud del detector (m)</translation>
    </message>
    <message>
      <source>Give the height above sea level in m, −1000 to 10000. For the formulas it counts where the correction for altitude is on.</source>
      <translation>Indique la altura sobre el nivel del mar en m, de −1000 a 10000. Para las fórmulas cuenta donde está activada la corrección por altitud.</translation>
    </message>
    <message>
      <source>Materials whose energy loss is compared</source>
      <translation>Materiales cuya pérdida de energía se compara</translation>
    </message>
    <message>
      <source>The material of the rock is shown in any case.</source>
      <translation>El material de la roca se muestra en todo caso.</translation>
    </message>
    <message>
      <source>Table of spectra</source>
      <translation>Tabla de espectros</translation>
    </message>
    <message>
      <source>CSV: differential flux of every model, zenith angle and kinetic energy, and whether the model was made for it.</source>
      <translation>CSV: flujo diferencial de cada modelo, ángulo cenital y energía cinética, y si el modelo se hizo para ellos.</translation>
    </message>
    <message>
      <source>Table of fluxes behind rock</source>
      <translation>Tabla de flujos detrás de la roca</translation>
    </message>
    <message>
      <source>CSV: flux, open sky and transmission of every model, zenith angle and opacity.</source>
      <translation>CSV: flujo, cielo abierto y transmisión de cada modelo, ángulo cenital y opacidad.</translation>
    </message>
    <message>
      <source>Table of energy losses</source>
      <translation>Tabla de pérdidas de energía</translation>
    </message>
    <message>
      <source>CSV: stopping power and range of every material, and the polynomial beside it.</source>
      <translation>CSV: poder de frenado y alcance de cada material, y el polinomio al lado.</translation>
    </message>
    <message>
      <source>Table of minimum energies</source>
      <translation>Tabla de energías mínimas</translation>
    </message>
    <message>
      <source>CSV: kinetic energy that the material demands at every thickness, by each range law.</source>
      <translation>CSV: energía cinética que exige el material a cada espesor, según cada ley de alcance.</translation>
    </message>
    <message>
      <source>Picture of spectra, energy losses, minimum energies, transmission and flux.</source>
      <translation>Figura de espectros, pérdidas de energía, energías mínimas, transmisión y flujo.</translation>
    </message>
    <message>
      <source>One HTML file with figures, parameters, numbers, every warning and how to cite.</source>
      <translation>Un archivo HTML con figuras, parámetros, números, todas las advertencias y cómo citar.</translation>
    </message>
    <message>
      <source>Opacity of the thickness (g/cm²)</source>
      <translation>Opacidad del espesor (g/cm²)</translation>
    </message>
    <message>
      <source>Minimum kinetic energy (GeV)</source>
      <translation>Energía cinética mínima (GeV)</translation>
    </message>
    <message>
      <source>Largest over smallest flux of the models that hold</source>
      <translation>Flujo mayor dividido por el menor de los modelos válidos</translation>
    </message>
    <message>
      <source>Import muogram</source>
      <translation>Importar muograma</translation>
    </message>
    <message>
      <source>&lt;p&gt;Turns a text file into a muogram raster that every other algorithm takes: what a telescope counted, or what another program computed.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Convierte un archivo de texto en un ráster de muograma que aceptan todos los demás algoritmos: lo que contó un telescopio, o lo que calculó otro programa.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Tables&lt;/b&gt; have one line for each direction, in any order: azimuth, elevation or zenith angle, value and, if there is one, its standard error. Columns are found by their names (azimuth, zenith, elevation, flux, counts, error and the like, also in Spanish), or by the names and numbers that you give. Units in the names, such as [rad] or (deg), are heeded. A table without names has the columns azimuth, vertical angle, value and error in this order; say then whether the vertical angle is an elevation or a zenith angle.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Las &lt;b&gt;tablas&lt;/b&gt; tienen una línea por dirección, en cualquier orden: azimut, elevación o ángulo cenital, valor y, si lo hay, su error estándar. Las columnas se encuentran por sus nombres (azimuth, zenith, elevation, flux, counts, error y similares, también en español), o por los nombres y números que usted indique. Se atienden las unidades en los nombres, como [rad] o (deg). Una tabla sin nombres tiene las columnas azimut, ángulo vertical, valor y error en este orden; diga entonces si el ángulo vertical es una elevación o un ángulo cenital.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Matrices&lt;/b&gt; have one line for each row of pixels. Give the angles of the first and the last column and row, or a reference muogram of the same size.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Las &lt;b&gt;matrices&lt;/b&gt; tienen una línea por fila de píxeles. Indique los ángulos de la primera y la última columna y fila, o un muograma de referencia del mismo tamaño.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Files of the first MUYSC&lt;/b&gt; (.dat with the lines Op and Pp) are recognised; detector, target and boresight come from them. Their directions and lengths are approximate.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Se reconocen los &lt;b&gt;archivos del primer MUYSC&lt;/b&gt; (.dat con las líneas Op y Pp); de ellos se toman detector, objetivo y eje. Sus direcciones y longitudes son aproximadas.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;A muogram is a regular and complete grid: a direction that is missing, there twice or off the grid is refused with its line. Write nan where nothing was measured.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Un muograma es una rejilla regular y completa: una dirección que falta, está repetida o queda fuera de la rejilla se rechaza indicando su línea. Escriba nan donde no se midió nada.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;The reference muogram, usually the simulated thickness, hands over what it says of detector, target and boresight; whatever is given beside it counts more.&lt;/p&gt;</source>
      <translation>&lt;p&gt;El muograma de referencia, normalmente el espesor simulado, aporta lo que dice de detector, objetivo y eje; lo que se indique además prevalece.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Text table or matrix</source>
      <translation>Tabla o matriz de texto</translation>
    </message>
    <message>
      <source>Text file: lines of azimuth, elevation or zenith angle, value and perhaps error in any order, a matrix of values, or a file of the first MUYSC. Tabs, semicolons, commas or blanks separate the numbers.</source>
      <translation>Archivo de texto: líneas con azimut, elevación o ángulo cenital, valor y quizás error en cualquier orden, una matriz de valores, o un archivo del primer MUYSC. Tabuladores, punto y coma, comas o espacios separan los números.</translation>
    </message>
    <message>
      <source>Quantity of the values</source>
      <translation>Magnitud de los valores</translation>
    </message>
    <message>
      <source>What the values are. They must be in the unit of the quantity once multiplied by the factor: flux cm⁻² sr⁻¹ day⁻¹, thickness m, opacity g/cm², density g/cm³, open_sky cm⁻² sr⁻¹ day⁻¹, exposure days, distance m.</source>
      <translation>Qué son los valores. Deben quedar en la unidad de la magnitud una vez multiplicados por el factor: flux cm⁻² sr⁻¹ day⁻¹, thickness m, opacity g/cm², density g/cm³, open_sky cm⁻² sr⁻¹ day⁻¹, exposure days, distance m.</translation>
    </message>
    <message>
      <source>Layout</source>
      <translation>Disposición</translation>
    </message>
    <message>
      <source>table: one line for each direction. matrix: one line for each row of pixels. auto: a table if columns are named or directions come again and again.</source>
      <translation>table: una línea por dirección. matrix: una línea por fila de píxeles. auto: una tabla si las columnas tienen nombre o las direcciones se repiten una y otra vez.</translation>
    </message>
    <message>
      <source>Vertical angle</source>
      <translation>Ángulo vertical</translation>
    </message>
    <message>
      <source>Whether the vertical angle is an elevation above the horizon or a zenith angle. auto takes what the column's name says.</source>
      <translation>Si el ángulo vertical es una elevación sobre el horizonte o un ángulo cenital. auto toma lo que dice el nombre de la columna.</translation>
    </message>
    <message>
      <source>Unit of the angles</source>
      <translation>Unidad de los ángulos</translation>
    </message>
    <message>
      <source>Unit of the angles in the file, and of those of a matrix given below. auto takes what the names of the columns say, and else degrees.</source>
      <translation>Unidad de los ángulos del archivo, y de los de una matriz indicados abajo. auto toma lo que dicen los nombres de las columnas y, si no, grados.</translation>
    </message>
    <message>
      <source>Column of the azimuth</source>
      <translation>Columna del azimut</translation>
    </message>
    <message>
      <source>Name or number (from 1) of the column of the azimuth. Empty finds it by its name, else the first.</source>
      <translation>Nombre o número (desde 1) de la columna del azimut. Vacío la busca por su nombre; si no, la primera.</translation>
    </message>
    <message>
      <source>Column of the vertical angle</source>
      <translation>Columna del ángulo vertical</translation>
    </message>
    <message>
      <source>Name or number (from 1) of the column of the vertical angle. Empty finds it by its name, else the second.</source>
      <translation>Nombre o número (desde 1) de la columna del ángulo vertical. Vacío la busca por su nombre; si no, la segunda.</translation>
    </message>
    <message>
      <source>Column of the values</source>
      <translation>Columna de los valores</translation>
    </message>
    <message>
      <source>Name or number (from 1) of the column of the values. Empty finds it by its name, else the third.</source>
      <translation>Nombre o número (desde 1) de la columna de los valores. Vacío la busca por su nombre; si no, la tercera.</translation>
    </message>
    <message>
      <source>Column of the standard errors</source>
      <translation>Columna de los errores estándar</translation>
    </message>
    <message>
      <source>Name or number (from 1) of the column of the standard errors. Empty finds it by its name, if there is one.</source>
      <translation>Nombre o número (desde 1) de la columna de los errores estándar. Vacío la busca por su nombre, si existe.</translation>
    </message>
    <message>
      <source>Factor of the values</source>
      <translation>Factor de los valores</translation>
    </message>
    <message>
      <source>Give the number that values and errors are multiplied by, other than 0: 86400 turns a flux per second into one per day, 1000 kilometres into metres.</source>
      <translation>Indique el número por el que se multiplican valores y errores, distinto de 0: 86400 convierte un flujo por segundo en uno por día, 1000 kilómetros en metros.</translation>
    </message>
    <message>
      <source>Number for no data (empty: none)</source>
      <translation>Número para sin dato (vacío: ninguno)</translation>
    </message>
    <message>
      <source>Give the number that stands for a missing value. Words such as nan, and empty fields, always do.</source>
      <translation>Indique el número que representa un valor ausente. Palabras como nan, y los campos vacíos, siempre lo hacen.</translation>
    </message>
    <message>
      <source>Angles count from the boresight</source>
      <translation>Los ángulos cuentan desde el eje</translation>
    </message>
    <message>
      <source>Whether the angles of the file are measured from the boresight rather than from north and the horizon.</source>
      <translation>Si los ángulos del archivo se miden desde el eje del telescopio en lugar de desde el norte y el horizonte.</translation>
    </message>
    <message>
      <source>Azimuth grows</source>
      <translation>El azimut crece</translation>
    </message>
    <message>
      <source>clockwise as seen from above (north, east, south), or counterclockwise.</source>
      <translation>clockwise: en sentido horario visto desde arriba (norte, este, sur). counterclockwise: en sentido antihorario.</translation>
    </message>
    <message>
      <source>Matrix: azimuth of the first column</source>
      <translation>Matriz: azimut de la primera columna</translation>
    </message>
    <message>
      <source>Give the azimuth of the pixel centres in the first column of a matrix, in the unit of the angles. Not needed with a reference muogram of the same size.</source>
      <translation>Indique el azimut de los centros de píxel de la primera columna de una matriz, en la unidad de los ángulos. No hace falta con un muograma de referencia del mismo tamaño.</translation>
    </message>
    <message>
      <source>Matrix: azimuth of the last column</source>
      <translation>Matriz: azimut de la última columna</translation>
    </message>
    <message>
      <source>Give the azimuth of the pixel centres in the last column of a matrix, in the unit of the angles. Not needed with a reference muogram of the same size.</source>
      <translation>Indique el azimut de los centros de píxel de la última columna de una matriz, en la unidad de los ángulos. No hace falta con un muograma de referencia del mismo tamaño.</translation>
    </message>
    <message>
      <source>Matrix: vertical angle of the first row</source>
      <translation>Matriz: ángulo vertical de la primera fila</translation>
    </message>
    <message>
      <source>Give the vertical angle of the pixel centres in the first row of a matrix, in the unit of the angles. Not needed with a reference muogram of the same size.</source>
      <translation>Indique el ángulo vertical de los centros de píxel de la primera fila de una matriz, en la unidad de los ángulos. No hace falta con un muograma de referencia del mismo tamaño.</translation>
    </message>
    <message>
      <source>Matrix: vertical angle of the last row</source>
      <translation>Matriz: ángulo vertical de la última fila</translation>
    </message>
    <message>
      <source>Give the vertical angle of the pixel centres in the last row of a matrix, in the unit of the angles. Not needed with a reference muogram of the same size.</source>
      <translation>Indique el ángulo vertical de los centros de píxel de la última fila de una matriz, en la unidad de los ángulos. No hace falta con un muograma de referencia del mismo tamaño.</translation>
    </message>
    <message>
      <source>Matrix of errors</source>
      <translation>Matriz de errores</translation>
    </message>
    <message>
      <source>Text file of the standard errors of a matrix, of the same size.</source>
      <translation>Archivo de texto de los errores estándar de una matriz, del mismo tamaño.</translation>
    </message>
    <message>
      <source>Reference muogram</source>
      <translation>Muograma de referencia</translation>
    </message>
    <message>
      <source>Muogram seen from the same place, such as the thickness: what it says of the detector is taken over, and its directions for a matrix without angles. What is given below counts more.</source>
      <translation>Muograma visto desde el mismo lugar, como el espesor: se adopta lo que dice del detector, y sus direcciones para una matriz sin ángulos. Lo que se indique abajo prevalece.</translation>
    </message>
    <message>
      <source>Where the telescope stood. As text: x,y [EPSG:code]; without a code longitude and latitude (EPSG:4326).</source>
      <translation>Dónde estaba el telescopio. Como texto: x,y [EPSG:code]; sin código, longitud y latitud (EPSG:4326).</translation>
    </message>
    <message>
      <source>Detector elevation (m, empty: the reference's)</source>
      <translation>Elevación del detector (m, vacío: la de la referencia)</translation>
    </message>
    <message>
      <source>Give the altitude of the detector in m, −1000 to 10000; later steps need it for the altitude correction.</source>
      <translation>Indique la altitud del detector en m, de −1000 a 10000; los pasos posteriores la necesitan para la corrección por altitud.</translation>
    </message>
    <message>
      <source>Boresight azimuth (°, empty: middle of the picture)</source>
      <translation>Azimut del eje (°, vacío: centro de la imagen)</translation>
    </message>
    <message>
      <source>Give the azimuth that the telescope pointed to, in degrees clockwise from north, −360 to 360.</source>
      <translation>Indique el azimut al que apuntaba el telescopio, en grados en sentido horario desde el norte, de −360 a 360.</translation>
    </message>
    <message>
      <source>Boresight elevation (°, empty: middle of the picture)</source>
      <translation>Elevación del eje (°, vacío: centro de la imagen)</translation>
    </message>
    <message>
      <source>Give the elevation that the telescope pointed to, in degrees, −90 to 90.</source>
      <translation>Indique la elevación a la que apuntaba el telescopio, en grados, de −90 a 90.</translation>
    </message>
    <message>
      <source>Exposure (days, empty: not known)</source>
      <translation>Exposición (días, vacío: desconocida)</translation>
    </message>
    <message>
      <source>Give the days of counting, above 0; kept as DAYS in the muogram.</source>
      <translation>Indique los días de conteo, mayor que 0; se guardan como DAYS en el muograma.</translation>
    </message>
    <message>
      <source>Acceptance of a pixel (cm² sr, empty: not known)</source>
      <translation>Aceptancia de un píxel (cm² sr, vacío: desconocida)</translation>
    </message>
    <message>
      <source>Give the acceptance of one pixel in cm² sr, above 0; kept in the muogram.</source>
      <translation>Indique la aceptancia de un píxel en cm² sr, mayor que 0; se guarda en el muograma.</translation>
    </message>
    <message>
      <source>The values as a GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Los valores como GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Errors</source>
      <translation>Errores</translation>
    </message>
    <message>
      <source>The standard errors, where the file holds any, on the same directions.</source>
      <translation>Los errores estándar, si el archivo los contiene, en las mismas direcciones.</translation>
    </message>
    <message>
      <source>Pixels</source>
      <translation>Píxeles</translation>
    </message>
    <message>
      <source>Pixels without a value</source>
      <translation>Píxeles sin valor</translation>
    </message>
    <message>
      <source>Sum of the values</source>
      <translation>Suma de los valores</translation>
    </message>
    <message>
      <source>Muon flux through rock</source>
      <translation>Flujo de muones a través de la roca</translation>
    </message>
    <message>
      <source>&lt;p&gt;Computes minimum energy, muon flux, transmission and exposure time behind rock that is already known as a muogram of thickness or opacity; no elevation model is needed.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Calcula energía mínima, flujo de muones, transmisión y tiempo de exposición detrás de roca ya conocida como muograma de espesor u opacidad; no hace falta un modelo de elevación.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;Use it to compare flux models, densities or telescopes on one geometry, or to bring in a thickness from elsewhere. Give exactly one of the two muograms. The detector's elevation, for the altitude correction, is taken from the muogram unless given.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Sirve para comparar modelos de flujo, densidades o telescopios con una misma geometría, o para traer un espesor de otra parte. Indique exactamente uno de los dos muogramas. La elevación del detector, para la corrección por altitud, se toma del muograma salvo que se indique.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;The physics is that of &lt;i&gt;Muon radiography&lt;/i&gt;; the same input gives the same flux.&lt;/p&gt;</source>
      <translation>&lt;p&gt;La física es la de &lt;i&gt;Radiografía de muones&lt;/i&gt;; la misma entrada da el mismo flujo.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Muogram of rock thickness in m, as radiography writes it. Give this or an opacity muogram.</source>
      <translation>Muograma del espesor de roca en m, como lo escribe la radiografía. Indique este o un muograma de opacidad.</translation>
    </message>
    <message>
      <source>Opacity muogram</source>
      <translation>Muograma de opacidad</translation>
    </message>
    <message>
      <source>Muogram of opacity in g/cm². Give this or a thickness muogram.</source>
      <translation>Muograma de la opacidad en g/cm². Indique este o un muograma de espesor.</translation>
    </message>
    <message>
      <source>Give the altitude of the detector in m, −1000 to 10000, for the altitude correction. Empty takes what the muogram says.</source>
      <translation>Indique la altitud del detector en m, de −1000 a 10000, para la corrección por altitud. Vacío toma lo que dice el muograma.</translation>
    </message>
    <message>
      <source>Acceptance of a pixel (cm² sr)</source>
      <translation>Aceptancia de un píxel (cm² sr)</translation>
    </message>
    <message>
      <source>Give the acceptance of one pixel in cm² sr, above 0. It divides the exposure time.</source>
      <translation>Indique la aceptancia de un píxel en cm² sr, mayor que 0. Divide el tiempo de exposición.</translation>
    </message>
    <message>
      <source>Muons per pixel</source>
      <translation>Muones por píxel</translation>
    </message>
    <message>
      <source>Give the number of muons wanted in each pixel, above 0. 10 muons give the flux to about 32 %, 100 to 10 %.</source>
      <translation>Indique el número de muones deseado en cada píxel, mayor que 0. 10 muones dan el flujo con un 32 % aproximadamente, 100 con un 10 %.</translation>
    </message>
    <message>
      <source>A telescope in place of ACCEPTANCE: each pixel then has the acceptance of the telescope in its direction, and none outside its field of view. none takes ACCEPTANCE. A telescope that was built, or custom for the numbers below. A preset wins over numbers, and the log says which were not used. mute: 30 × 30 bars of 4 cm, 250 cm; gibert2010: 32 × 32 bars of 5 cm, 100 cm; carbone2014: 16 × 16 bars of 5 cm, 170 cm; lopresti2020: 99 × 99 bars of 1 cm, 97 cm; lesparre2012: 16 × 16 bars of 5 cm, 115 cm; lesparre2010: 16 × 16 bars of 5 cm, 80 cm; uchida2009: 12 × 12 bars of 7 cm, 100 cm; muraves: 60 × 60 bars of 3.4 cm, 200 cm.</source>
      <translation>Un telescopio en lugar de ACCEPTANCE: cada píxel tiene entonces la aceptancia del telescopio en su dirección, y ninguna fuera de su campo de visión. none toma ACCEPTANCE. Un telescopio que se construyó, o custom para los números de abajo. Un telescopio de la lista prevalece sobre los números, y el registro dice cuáles no se usaron. mute: 30 × 30 barras de 4 cm, 250 cm; gibert2010: 32 × 32 barras de 5 cm, 100 cm; carbone2014: 16 × 16 barras de 5 cm, 170 cm; lopresti2020: 99 × 99 barras de 1 cm, 97 cm; lesparre2012: 16 × 16 barras de 5 cm, 115 cm; lesparre2010: 16 × 16 barras de 5 cm, 80 cm; uchida2009: 12 × 12 barras de 7 cm, 100 cm; muraves: 60 × 60 barras de 3.4 cm, 200 cm.</translation>
    </message>
    <message>
      <source>Minimum muon energy (GeV)</source>
      <translation>Energía mínima de los muones (GeV)</translation>
    </message>
    <message>
      <source>Kinetic energy of the slowest muons that get through. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Energía cinética de los muones más lentos que logran pasar. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Integral flux of the muons that get through. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Flujo integral de los muones que logran pasar. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Open-sky muon flux (cm⁻² sr⁻¹ day⁻¹)</source>
      <translation>Flujo de muones a cielo abierto (cm⁻² sr⁻¹ day⁻¹)</translation>
    </message>
    <message>
      <source>Integral flux that there would be without the rock. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Flujo integral que habría sin la roca. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Transmission</source>
      <translation>Transmisión</translation>
    </message>
    <message>
      <source>Flux over open-sky flux, 1 in the sky. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Flujo dividido por el de cielo abierto, 1 en el cielo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Days until a pixel has counted the muons wanted. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Días hasta que un píxel ha contado los muones deseados. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Smallest muon flux (cm⁻² sr⁻¹ day⁻¹)</source>
      <translation>Menor flujo de muones (cm⁻² sr⁻¹ day⁻¹)</translation>
    </message>
    <message>
      <source>One standard error of the flux model below the flux; with a formula, the smallest flux over those that hold for the ray's energy and zenith. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Un error estándar del modelo de flujo por debajo del flujo; con una fórmula, el menor flujo entre las que son válidas para la energía y el ángulo cenital del rayo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Largest muon flux (cm⁻² sr⁻¹ day⁻¹)</source>
      <translation>Mayor flujo de muones (cm⁻² sr⁻¹ day⁻¹)</translation>
    </message>
    <message>
      <source>One standard error of the flux model above the flux; with a formula, the largest flux over those that hold for the ray's energy and zenith. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Un error estándar del modelo de flujo por encima del flujo; con una fórmula, el mayor flujo entre las que son válidas para la energía y el ángulo cenital del rayo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Picture of thickness and flux side by side, with contours, skyline and target.</source>
      <translation>Figura de espesor y flujo lado a lado, con curvas de nivel, perfil del horizonte y objetivo.</translation>
    </message>
    <message>
      <source>Largest thickness (m)</source>
      <translation>Mayor espesor (m)</translation>
    </message>
    <message>
      <source>Pixels without a flux</source>
      <translation>Píxeles sin flujo</translation>
    </message>
    <message>
      <source>Muon radiography</source>
      <translation>Radiografía de muones</translation>
    </message>
    <message>
      <source>&lt;p&gt;Simulates what a muon telescope sees of a mountain: rock thickness, opacity, minimum muon energy, muon flux, transmission and exposure time, as rasters of azimuth (to the right, degrees clockwise from north) against elevation angle (upwards).&lt;/p&gt;</source>
      <translation>&lt;p&gt;Simula lo que un telescopio de muones ve de una montaña: espesor de roca, opacidad, energía mínima de los muones, flujo de muones, transmisión y tiempo de exposición, como rásteres de azimut (hacia la derecha, en grados en sentido horario desde el norte) y ángulo de elevación (hacia arriba).&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose an elevation model, click where the telescope stands and what it points at, and run. The line between the two points is the middle of the field of view.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Cómo se usa.&lt;/b&gt; Elija un modelo de elevación, haga clic donde está el telescopio y en aquello a lo que apunta, y ejecute. La línea entre los dos puntos es el centro del campo de visión.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; Rays are straight and exact on the surface interpolated between the cell centres of the elevation model, with the curvature of the Earth; every ridge on the way counts, as far as the model reaches. Thickness times density is the opacity; the range table of the material turns it into the lowest energy that gets through, and the flux model is integrated from there.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué hace.&lt;/b&gt; Los rayos son rectos y exactos sobre la superficie interpolada entre los centros de celda del modelo de elevación, con la curvatura de la Tierra; cuenta cada cresta del camino, hasta donde llegue el modelo. El espesor por la densidad es la opacidad; la tabla de alcances del material la convierte en la menor energía que logra pasar, y el modelo de flujo se integra desde allí.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does not know&lt;/b&gt; has no data, never 0, and is counted in the log by cause: rays that reach the edge of the elevation model in rock, pass a gap in it, or point at or below the horizon (no flux model has an answer there, though the thickness is given). Pixels without rock have thickness 0 and transmission 1.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Lo que no se conoce&lt;/b&gt; queda sin dato, nunca 0, y se cuenta en el registro según la causa: rayos que llegan al borde del modelo de elevación dentro de la roca, que pasan por un hueco de él, o que apuntan al horizonte o por debajo (ningún modelo de flujo tiene respuesta allí, aunque el espesor sí se da). Los píxeles sin roca tienen espesor 0 y transmisión 1.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;The rasters describe themselves: &lt;i&gt;Muon flux through rock&lt;/i&gt; and &lt;i&gt;Drape muogram on the terrain&lt;/i&gt; need nothing else.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Los rásteres se describen a sí mismos: &lt;i&gt;Flujo de muones a través de la roca&lt;/i&gt; y &lt;i&gt;Proyectar muograma sobre el terreno&lt;/i&gt; no necesitan nada más.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Azimuth aperture (°)</source>
      <translation>Apertura en azimut (°)</translation>
    </message>
    <message>
      <source>Give the full width of the field of view in azimuth, above 0° and up to 360°.</source>
      <translation>Indique el ancho total del campo de visión en azimut, mayor que 0° y hasta 360°.</translation>
    </message>
    <message>
      <source>Elevation aperture (°)</source>
      <translation>Apertura en elevación (°)</translation>
    </message>
    <message>
      <source>Give the full height of the field of view in elevation, above 0° and up to 180°; it must not reach past the zenith.</source>
      <translation>Indique la altura total del campo de visión en elevación, mayor que 0° y hasta 180°; no debe pasar del cenit.</translation>
    </message>
    <message>
      <source>Pixels in azimuth</source>
      <translation>Píxeles en azimut</translation>
    </message>
    <message>
      <source>Give the number of muogram columns, 1 or more.</source>
      <translation>Indique el número de columnas del muograma, 1 o más.</translation>
    </message>
    <message>
      <source>Pixels in elevation</source>
      <translation>Píxeles en elevación</translation>
    </message>
    <message>
      <source>Give the number of muogram rows, 1 or more.</source>
      <translation>Indique el número de filas del muograma, 1 o más.</translation>
    </message>
    <message>
      <source>Distance to the first rock (m)</source>
      <translation>Distancia a la primera roca (m)</translation>
    </message>
    <message>
      <source>Length of each ray from the detector to the first rock. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Longitud de cada rayo desde el detector hasta la primera roca. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Standard error of the thickness from those of terrain and pointing. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation>Error estándar del espesor a partir de los del terreno y del apuntado. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Field of view</source>
      <translation>Campo de visión</translation>
    </message>
    <message>
      <source>Polygons on the map: the sector that the aperture covers, and within it the ground seen, from the nearest to the farthest rock face along each azimuth.</source>
      <translation>Polígonos en el mapa: el sector que cubre la apertura y, dentro de él, el suelo visto, desde la cara de roca más cercana hasta la más lejana en cada azimut.</translation>
    </message>
    <message>
      <source>Muograms from many sites</source>
      <translation>Muogramas desde muchos sitios</translation>
    </message>
    <message>
      <source>Survey</source>
      <translation>Campaña</translation>
    </message>
    <message>
      <source>&lt;p&gt;Simulates a radiography of one target from every point of a layer, and writes the muograms of all sites into one folder.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Simula una radiografía de un objetivo desde cada punto de una capa, y escribe los muogramas de todos los sitios en una carpeta.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose an elevation model and a layer of points, click what the telescopes point at, choose the quantities and a folder, and run. A field of the layer may hold the name of each site, another the height of its telescope above the ground.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Cómo se usa.&lt;/b&gt; Elija un modelo de elevación y una capa de puntos, haga clic en aquello a lo que apuntan los telescopios, elija las magnitudes y una carpeta, y ejecute. Un campo de la capa puede contener el nombre de cada sitio, otro la altura de su telescopio sobre el suelo.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; Each site is a &lt;i&gt;Muon radiography&lt;/i&gt; of its own, with the same field of view, rock and telescope. The files are called after the site and the quantity, such as &lt;i&gt;site_01_thickness.tif&lt;/i&gt;. The index is a point layer with the names of these files and the numbers of each site.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué hace.&lt;/b&gt; Cada sitio es una &lt;i&gt;Radiografía de muones&lt;/i&gt; propia, con el mismo campo de visión, roca y telescopio. Los archivos se llaman según el sitio y la magnitud, como &lt;i&gt;site_01_thickness.tif&lt;/i&gt;. El índice es una capa de puntos con los nombres de estos archivos y los números de cada sitio.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Sites that cannot be used&lt;/b&gt;, because they lie off the elevation model or in a gap of it, are skipped, named and counted. The warnings of all sites are gathered: those that differ in numbers alone are said once.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Los sitios que no se pueden usar&lt;/b&gt;, porque quedan fuera del modelo de elevación o en un hueco de él, se omiten, se nombran y se cuentan. Las advertencias de todos los sitios se reúnen: las que solo difieren en números se dicen una vez.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;All files appear together&lt;/b&gt; when the last site is done. Muograms of an earlier run under the same names are replaced; any other file in the way ends the run before it starts.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Todos los archivos aparecen juntos&lt;/b&gt; cuando termina el último sitio. Se reemplazan los muogramas de una ejecución anterior con los mismos nombres; cualquier otro archivo que estorbe termina la ejecución antes de empezar.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Sites</source>
      <translation>Sitios</translation>
    </message>
    <message>
      <source>Layer of points where telescopes stand, on the DEM, in any coordinate reference system. Sites off the DEM are skipped with a warning.</source>
      <translation>Capa de puntos donde están los telescopios, sobre el MDE, en cualquier sistema de referencia de coordenadas. Los sitios fuera del MDE se omiten con una advertencia.</translation>
    </message>
    <message>
      <source>Field of the names</source>
      <translation>Campo de los nombres</translation>
    </message>
    <message>
      <source>Field with the name of each site, which its files begin with. Empty: site_01, site_02 and so on, by the order in the layer.</source>
      <translation>Campo con el nombre de cada sitio, con el que empiezan sus archivos. Vacío: site_01, site_02 y así sucesivamente, según el orden en la capa.</translation>
    </message>
    <message>
      <source>Field of the heights above ground</source>
      <translation>Campo de las alturas sobre el suelo</translation>
    </message>
    <message>
      <source>Field with the height of each telescope above the ground in m, −10000 to 10000. Where it is empty the detector height above counts.</source>
      <translation>Campo con la altura de cada telescopio sobre el suelo en m, de −10000 a 10000. Donde está vacío cuenta la altura del detector de arriba.</translation>
    </message>
    <message>
      <source>Quantities</source>
      <translation>Magnitudes</translation>
    </message>
    <message>
      <source>What to write for each site, one raster each.</source>
      <translation>Qué se escribe para cada sitio, un ráster por magnitud.</translation>
    </message>
    <message>
      <source>Worker processes (empty: one for each processor)</source>
      <translation>Procesos de cálculo (vacío: uno por procesador)</translation>
    </message>
    <message>
      <source>Give the number of processes that compute, 0 or more; 0 and 1 compute in QGIS itself.</source>
      <translation>Indique el número de procesos que calculan, 0 o más; 0 y 1 calculan en el propio QGIS.</translation>
    </message>
    <message>
      <source>Folder of the muograms</source>
      <translation>Carpeta de los muogramas</translation>
    </message>
    <message>
      <source>Holds a GeoTIFF for each site and quantity, such as site_01_thickness.tif. Muograms of an earlier run under the same names are replaced; other files are not.</source>
      <translation>Contiene un GeoTIFF por sitio y magnitud, como site_01_thickness.tif. Se reemplazan los muogramas de una ejecución anterior con los mismos nombres; los demás archivos no.</translation>
    </message>
    <message>
      <source>Index of the muograms</source>
      <translation>Índice de los muogramas</translation>
    </message>
    <message>
      <source>Layer of the sites with the name of each file in the folder, detector elevation, distance and direction of the target, largest thickness, median exposure and unknown pixels.</source>
      <translation>Capa de los sitios con el nombre de cada archivo de la carpeta, elevación del detector, distancia y dirección del objetivo, mayor espesor, mediana de la exposición y píxeles desconocidos.</translation>
    </message>
    <message>
      <source>Sites with muograms</source>
      <translation>Sitios con muogramas</translation>
    </message>
    <message>
      <source>Sites skipped</source>
      <translation>Sitios omitidos</translation>
    </message>
    <message>
      <source>Muograms written</source>
      <translation>Muogramas escritos</translation>
    </message>
    <message>
      <source>Largest thickness from any site (m)</source>
      <translation>Mayor espesor desde cualquier sitio (m)</translation>
    </message>
    <message>
      <source>Median over the sites of the median exposure (days)</source>
      <translation>Mediana entre los sitios de la mediana de la exposición (días)</translation>
    </message>
    <message>
      <source>Pixels without a flux from all sites</source>
      <translation>Píxeles sin flujo desde todos los sitios</translation>
    </message>
    <message>
      <source>Compare reconstruction methods</source>
      <translation>Comparar métodos de reconstrucción</translation>
    </message>
    <message>
      <source>Tomography</source>
      <translation>Tomografía</translation>
    </message>
    <message>
      <source>&lt;p&gt;Compares the reconstruction methods on the Shepp–Logan head, a test image of ten ellipses whose projections are known exactly: how near each comes, and in what time.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Compara los métodos de reconstrucción con la cabeza de Shepp–Logan, una imagen de prueba de diez elipses cuyas proyecciones se conocen con exactitud: cuánto se acerca cada uno, y en qué tiempo.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; The head is projected along parallel rays from evenly spaced directions over 180°, noise is added if asked for, and every method reconstructs the image from the same projections. The error is ‖R − T‖ / ‖T‖ of the reconstruction R against the head T, by the sum of squares over all pixels. The rays' paths through the pixels are computed once for all methods, and that time is told apart.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué hace.&lt;/b&gt; La cabeza se proyecta con rayos paralelos desde direcciones uniformemente espaciadas en 180°, se agrega ruido si se pide, y cada método reconstruye la imagen a partir de las mismas proyecciones. El error es ‖R − T‖ / ‖T‖ de la reconstrucción R respecto a la cabeza T, por la suma de cuadrados sobre todos los píxeles. Los recorridos de los rayos por los píxeles se calculan una vez para todos los métodos, y ese tiempo se informa aparte.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it tells.&lt;/b&gt; Which methods cope with few projections (lower &lt;i&gt;Projections&lt;/i&gt;) or with noise, and how many iterations they take. Filtered back-projection (&lt;i&gt;fbp&lt;/i&gt;) and &lt;i&gt;gridrec&lt;/i&gt; need parallel projections from all around and stand here for comparison alone: muograms look out from single points, so &lt;i&gt;Muon tomography&lt;/i&gt; cannot use them.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué dice.&lt;/b&gt; Qué métodos soportan pocas proyecciones (menos &lt;i&gt;Proyecciones&lt;/i&gt;) o ruido, y cuántas iteraciones necesitan. La retroproyección filtrada (&lt;i&gt;fbp&lt;/i&gt;) y &lt;i&gt;gridrec&lt;/i&gt; necesitan proyecciones paralelas de todo alrededor y están aquí solo para comparar: los muogramas miran desde puntos únicos, así que &lt;i&gt;Tomografía de muones&lt;/i&gt; no puede usarlos.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Regularisation.&lt;/b&gt; Each method's own strength is the one that serves muograms with noise; on this head with its many projections the penalised methods do better with less of it, such as 0.01.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Regularización.&lt;/b&gt; La intensidad propia de cada método es la que sirve para muogramas con ruido; en esta cabeza, con sus muchas proyecciones, los métodos penalizados funcionan mejor con menos, como 0.01.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;The Bayesian method needs the errors of the projections: it is told those of the noise, together with what the pixels' edges make of the projections.&lt;/p&gt;</source>
      <translation>&lt;p&gt;El método bayesiano necesita los errores de las proyecciones: se le dan los del ruido, junto con lo que los bordes de los píxeles hacen a las proyecciones.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Pixels along an edge</source>
      <translation>Píxeles por lado</translation>
    </message>
    <message>
      <source>Give the edge of the square image in pixels, 16 to 1024. Time and memory grow with its square.</source>
      <translation>Indique el lado de la imagen cuadrada en píxeles, de 16 a 1024. El tiempo y la memoria crecen con su cuadrado.</translation>
    </message>
    <message>
      <source>Projections</source>
      <translation>Proyecciones</translation>
    </message>
    <message>
      <source>Give the number of parallel projections, evenly spaced over 180°, 2 to 2000.</source>
      <translation>Indique el número de proyecciones paralelas, uniformemente espaciadas en 180°, de 2 a 2000.</translation>
    </message>
    <message>
      <source>Methods</source>
      <translation>Métodos</translation>
    </message>
    <message>
      <source>Methods to compare. fbp and gridrec need parallel projections and so exist here alone; all others serve muograms too.</source>
      <translation>Métodos que se comparan. fbp y gridrec necesitan proyecciones paralelas y por eso existen solo aquí; todos los demás sirven también para muogramas.</translation>
    </message>
    <message>
      <source>Noise (%)</source>
      <translation>Ruido (%)</translation>
    </message>
    <message>
      <source>Give the standard deviation of the projections' errors in percent of the largest projection, 0 to 100.</source>
      <translation>Indique la desviación estándar de los errores de las proyecciones en porcentaje de la mayor proyección, de 0 a 100.</translation>
    </message>
    <message>
      <source>Iterations (empty: each method's own)</source>
      <translation>Iteraciones (vacío: las propias de cada método)</translation>
    </message>
    <message>
      <source>Give the most iterations of every method, 1 or more; a sweep over all rays is one. Methods that converge sooner end sooner.</source>
      <translation>Indique el máximo de iteraciones de cada método, 1 o más; una es un barrido sobre todos los rayos. Los métodos que convergen antes terminan antes.</translation>
    </message>
    <message>
      <source>Relaxation (empty: each method's own)</source>
      <translation>Relajación (vacío: la propia de cada método)</translation>
    </message>
    <message>
      <source>Give the share of each correction that art, bart, sart and sirt apply, above 0 and below 2.</source>
      <translation>Indique la fracción de cada corrección que aplican art, bart, sart y sirt, mayor que 0 y menor que 2.</translation>
    </message>
    <message>
      <source>Regularisation (empty: each method's own)</source>
      <translation>Regularización (vacío: la propia de cada método)</translation>
    </message>
    <message>
      <source>Give the strength of the penalty on rough images, 0 or more; at 1 a step between neighbours weighs as much as the misfit of a pixel.</source>
      <translation>Indique la intensidad de la penalización de las imágenes rugosas, 0 o más; con 1 un salto entre vecinos pesa tanto como el desajuste de un píxel.</translation>
    </message>
    <message>
      <source>Seed of the noise</source>
      <translation>Semilla del ruido</translation>
    </message>
    <message>
      <source>Give a whole number, 0 or more; the same seed draws the same noise.</source>
      <translation>Indique un número entero, 0 o más; la misma semilla genera el mismo ruido.</translation>
    </message>
    <message>
      <source>Table of methods</source>
      <translation>Tabla de métodos</translation>
    </message>
    <message>
      <source>CSV: iterations, seconds, errors and misfit of every method.</source>
      <translation>CSV: iteraciones, segundos, errores y desajuste de cada método.</translation>
    </message>
    <message>
      <source>Picture of the head and every reconstruction, of error against time and of misfit against iterations.</source>
      <translation>Figura de la cabeza y de cada reconstrucción, del error frente al tiempo y del desajuste frente a las iteraciones.</translation>
    </message>
    <message>
      <source>One HTML file with the panel, parameters, numbers and how to cite.</source>
      <translation>Un archivo HTML con el panel, los parámetros, los números y cómo citar.</translation>
    </message>
    <message>
      <source>Method of the smallest error</source>
      <translation>Método con el menor error</translation>
    </message>
    <message>
      <source>Smallest relative error</source>
      <translation>Menor error relativo</translation>
    </message>
    <message>
      <source>Time of that method (s)</source>
      <translation>Tiempo de ese método (s)</translation>
    </message>
    <message>
      <source>Relative error of one grey level</source>
      <translation>Error relativo de un solo nivel de gris</translation>
    </message>
    <message>
      <source>Time of the ray paths, once for all (s)</source>
      <translation>Tiempo de los recorridos de los rayos, una vez para todos (s)</translation>
    </message>
    <message>
      <source>Can this survey see it?</source>
      <translation>¿Puede verlo esta campaña?</translation>
    </message>
    <message>
      <source>&lt;p&gt;Shows before a campaign what its muon tomography can find. It puts a known body into the mountain, counts the muons that telescopes would count, reconstructs the densities from them, and says how much of the body is found again.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Muestra antes de una campaña lo que puede encontrar su tomografía de muones. Pone un cuerpo conocido en la montaña, cuenta los muones que contarían los telescopios, reconstruye con ellos las densidades y dice cuánto del cuerpo se recupera.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose an elevation model, click the target, and choose a body. The telescopes stand on the sites of a layer, or on a ring around the target. Each site of the ring is moved a little, to the flattest ground nearby; a steepest slope and a free view may be asked for, and sites without both are left out and counted.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Cómo se usa.&lt;/b&gt; Elija un modelo de elevación, haga clic en el objetivo y elija un cuerpo. Los telescopios están en los sitios de una capa, o en un anillo alrededor del objetivo. Cada sitio del anillo se desplaza un poco, hasta el suelo más plano cercano; se puede pedir una pendiente máxima y una vista libre, y los sitios sin ambas se omiten y se cuentan.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;The known model.&lt;/b&gt; &lt;i&gt;conduit&lt;/i&gt;: an upright cylinder. &lt;i&gt;sphere&lt;/i&gt;. &lt;i&gt;checkerboard&lt;/i&gt;: every other cube, to see where details are resolved. &lt;i&gt;uniform&lt;/i&gt;: no body at all, so that whatever structure comes out is noise. &lt;i&gt; polygons&lt;/i&gt;: bodies from a layer with the fields &lt;i&gt;density&lt;/i&gt; (g/cm³), &lt;i&gt;base&lt;/i&gt; and &lt;i&gt;top&lt;/i&gt; (m above sea level). The rock around has the density given with the physics.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;El modelo conocido.&lt;/b&gt; &lt;i&gt;conduit&lt;/i&gt;: un cilindro vertical (conducto). &lt;i&gt;sphere&lt;/i&gt;: una esfera. &lt;i&gt;checkerboard&lt;/i&gt;: uno de cada dos cubos (tablero), para ver dónde se resuelven los detalles. &lt;i&gt;uniform&lt;/i&gt;: ningún cuerpo, de modo que toda estructura que aparezca es ruido. &lt;i&gt; polygons&lt;/i&gt;: cuerpos de una capa con los campos &lt;i&gt;density&lt;/i&gt; (g/cm³), &lt;i&gt;base&lt;/i&gt; y &lt;i&gt;top&lt;/i&gt; (m sobre el nivel del mar). La roca alrededor tiene la densidad indicada con la física.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; The thickness of rock comes from the elevation model as in &lt;i&gt;Muon radiography&lt;/i&gt;, the body from voxels of half the size; so the data are not made by the matrix that is inverted. The flux behind it, the acceptance and the days give the muons expected, and counts are drawn from them; the same seed draws the same counts. Counts are turned back into opacity with their errors, as in &lt;i&gt;Density from a measured muogram&lt;/i&gt;. Neighbouring pixels are merged up to a number of counts: pixels without a muon say no density, and leaving them out would make the rock look too light. Then the densities are found as in &lt;i&gt;Muon tomography&lt;/i&gt;. The real terrain is known better or worse than its model; here the model is the truth.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué hace.&lt;/b&gt; El espesor de roca viene del modelo de elevación como en &lt;i&gt;Radiografía de muones&lt;/i&gt;, y el cuerpo de vóxeles de la mitad del tamaño; así los datos no se hacen con la matriz que se invierte. El flujo detrás, la aceptancia y los días dan los muones esperados, y de ellos se sortean los conteos; la misma semilla da los mismos conteos. Los conteos se convierten de nuevo en opacidad con sus errores, como en &lt;i&gt;Densidad a partir de un muograma medido&lt;/i&gt;. Los píxeles vecinos se agrupan hasta cierto número de conteos: los píxeles sin ningún muon no dicen densidad, y omitirlos haría parecer la roca demasiado ligera. Luego se buscan las densidades como en &lt;i&gt;Tomografía de muones&lt;/i&gt;. El terreno real se conoce mejor o peor que su modelo; aquí el modelo es la verdad.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Reading the result.&lt;/b&gt; &lt;i&gt;Contrast&lt;/i&gt;: that found over the true one, 1 where the whole of it is found. &lt;i&gt;Spread&lt;/i&gt;: standard deviation of the errors; for the model uniform, of the densities themselves. The errors of the views compare the sums along the three axes, as lengths in rock; the top view is normalised. Only voxels that a ray passes are compared, and the others are counted.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Cómo leer el resultado.&lt;/b&gt; &lt;i&gt;Contraste&lt;/i&gt;: el encontrado dividido por el verdadero, 1 donde se encuentra por completo. &lt;i&gt;Dispersión&lt;/i&gt;: desviación estándar de los errores; para el modelo uniform, de las propias densidades. Los errores de las vistas comparan las sumas a lo largo de los tres ejes, como longitudes en la roca; la vista superior está normalizada. Solo se comparan los vóxeles por los que pasa un rayo, y los demás se cuentan.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Choosing the settings.&lt;/b&gt; Run the model uniform first: a prior, or a regularisation, under which the mountain stays uniform suits the noise. With the same settings, see then what is left of the body. Neither needs to know the answer.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Cómo elegir los ajustes.&lt;/b&gt; Ejecute primero el modelo uniform: un conocimiento previo, o una regularización, con el que la montaña sigue uniforme se ajusta al ruido. Vea después, con los mismos ajustes, qué queda del cuerpo. Ninguno de los dos necesita saber la respuesta.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Time.&lt;/b&gt; The defaults answer in well under a minute. The finest voxels that make sense are those that two neighbouring rays tell apart.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Tiempo.&lt;/b&gt; Los valores predeterminados responden en bastante menos de un minuto. Los vóxeles más finos que tienen sentido son los que dos rayos vecinos distinguen.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Counts.&lt;/b&gt; With the method &lt;i&gt;counts&lt;/i&gt; each telescope counts along its own trajectories, as wide as they are, from finer sub-rays and voxels than those of the fit. Factors, boresights and terrain are off as their errors say. Several surveys are drawn, and the log ends in a verdict: how many standard errors the body is worth at its place and among all places, how often it is seen, how often one is seen where there is none, how much of its contrast is found, and how far off.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Conteos.&lt;/b&gt; Con el método &lt;i&gt;counts&lt;/i&gt; cada telescopio cuenta a lo largo de sus propias trayectorias, tan anchas como son, con subrayos y vóxeles más finos que los del ajuste. Factores, direcciones de apuntado y terreno se desvían según sus errores. Se sortean varias campañas, y el registro termina en un veredicto: cuántos errores estándar vale el cuerpo en su lugar y entre todos los lugares, cuántas veces se ve, cuántas veces se ve uno donde no lo hay, cuánto de su contraste se encuentra y a qué distancia.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Sites (empty: a ring around the target)</source>
      <translation>Sitios (vacío: un anillo alrededor del objetivo)</translation>
    </message>
    <message>
      <source>Sites on the ring</source>
      <translation>Sitios en el anillo</translation>
    </message>
    <message>
      <source>Give the number of sites on the ring, 1 or more, where no layer of sites is given.</source>
      <translation>Indique el número de sitios en el anillo, 1 o más, si no se da una capa de sitios.</translation>
    </message>
    <message>
      <source>Radius of the ring (m)</source>
      <translation>Radio del anillo (m)</translation>
    </message>
    <message>
      <source>Give the horizontal distance of the sites from the target in m, above 0.</source>
      <translation>Indique la distancia horizontal de los sitios al objetivo en m, mayor que 0.</translation>
    </message>
    <message>
      <source>Azimuth of the first site (°)</source>
      <translation>Azimut del primer sitio (°)</translation>
    </message>
    <message>
      <source>Give the azimuth of the first site as seen from the target, in degrees clockwise from north. The others follow clockwise, evenly spaced.</source>
      <translation>Indique el azimut del primer sitio visto desde el objetivo, en grados en sentido horario desde el norte. Los demás siguen en sentido horario, uniformemente espaciados.</translation>
    </message>
    <message>
      <source>Azimuth where the arc ends (°)</source>
      <translation>Azimut donde termina el arco (°)</translation>
    </message>
    <message>
      <source>Give the azimuth of the last site in degrees. A whole turn after the first is a full ring.</source>
      <translation>Indique el azimut del último sitio en grados. Una vuelta entera después del primero es un anillo completo.</translation>
    </message>
    <message>
      <source>Sites may be moved by (m)</source>
      <translation>Los sitios se pueden mover (m)</translation>
    </message>
    <message>
      <source>Give how far in m a site may be moved to flatter ground, 0 or more, less than the radius.</source>
      <translation>Indique cuánto en m se puede mover un sitio hacia suelo más plano, 0 o más, menos que el radio.</translation>
    </message>
    <message>
      <source>Steepest slope at a site (°, empty: any)</source>
      <translation>Pendiente máxima en un sitio (°, vacío: cualquiera)</translation>
    </message>
    <message>
      <source>Give the steepest ground in degrees, above 0 and up to 90, on which a site of the ring may lie. Sites without such ground nearby are left out.</source>
      <translation>Indique la mayor pendiente en grados, mayor que 0 y hasta 90, en la que puede estar un sitio del anillo. Los sitios sin suelo así cerca se omiten.</translation>
    </message>
    <message>
      <source>Sites of the ring see the target</source>
      <translation>Los sitios del anillo ven el objetivo</translation>
    </message>
    <message>
      <source>Whether sites are left out if ground rises above the line to the target on the nearest quarter of the way.</source>
      <translation>Si se omiten los sitios en los que el suelo sube por encima de la línea al objetivo en el cuarto más cercano del camino.</translation>
    </message>
    <message>
      <source>Known model</source>
      <translation>Modelo conocido</translation>
    </message>
    <message>
      <source>uniform: rock of one density. conduit: an upright cylinder. sphere. checkerboard: every other cube. polygons: what a layer holds.</source>
      <translation>uniform: roca de una sola densidad. conduit: un cilindro vertical. sphere: una esfera. checkerboard: uno de cada dos cubos. polygons: lo que contiene una capa.</translation>
    </message>
    <message>
      <source>Density of the rock around (g/cm³, empty: the material's own)</source>
      <translation>Densidad de la roca alrededor (g/cm³, vacío: la del material)</translation>
    </message>
    <message>
      <source>Give the density of the rock around the bodies in g/cm³, above 0 and up to 30.</source>
      <translation>Indique la densidad de la roca alrededor de los cuerpos en g/cm³, mayor que 0 y hasta 30.</translation>
    </message>
    <message>
      <source>Density of the body (g/cm³)</source>
      <translation>Densidad del cuerpo (g/cm³)</translation>
    </message>
    <message>
      <source>Give the density of conduit, sphere or every other cube in g/cm³, above 0 and up to 30.</source>
      <translation>Indique la densidad del conducto, la esfera o los cubos alternos en g/cm³, mayor que 0 y hasta 30.</translation>
    </message>
    <message>
      <source>Radius of conduit or sphere (m)</source>
      <translation>Radio del conducto o de la esfera (m)</translation>
    </message>
    <message>
      <source>Give the radius in m, above 0.</source>
      <translation>Indique el radio en m, mayor que 0.</translation>
    </message>
    <message>
      <source>Edge of the checkerboard's cubes (m)</source>
      <translation>Lado de los cubos del tablero (m)</translation>
    </message>
    <message>
      <source>Give the edge of a cube in m, above 0.</source>
      <translation>Indique el lado de un cubo en m, mayor que 0.</translation>
    </message>
    <message>
      <source>Position of the body (empty: the target)</source>
      <translation>Posición del cuerpo (vacío: el objetivo)</translation>
    </message>
    <message>
      <source>Axis of the conduit or middle of the sphere, on the DEM.</source>
      <translation>Eje del conducto o centro de la esfera, sobre el MDE.</translation>
    </message>
    <message>
      <source>Base of the conduit (m, empty: the volume's)</source>
      <translation>Base del conducto (m, vacío: la del volumen)</translation>
    </message>
    <message>
      <source>Give the height of the conduit's lower end in m above sea level.</source>
      <translation>Indique la altura del extremo inferior del conducto en m sobre el nivel del mar.</translation>
    </message>
    <message>
      <source>Top of the conduit (m, empty: the volume's)</source>
      <translation>Techo del conducto (m, vacío: el del volumen)</translation>
    </message>
    <message>
      <source>Give the height of the conduit's upper end in m above sea level; above the ground there is none of it.</source>
      <translation>Indique la altura del extremo superior del conducto en m sobre el nivel del mar; por encima del suelo no hay conducto.</translation>
    </message>
    <message>
      <source>Middle of the sphere (m, empty: the volume's)</source>
      <translation>Centro de la esfera (m, vacío: el del volumen)</translation>
    </message>
    <message>
      <source>Give the height of the sphere's middle in m above sea level.</source>
      <translation>Indique la altura del centro de la esfera en m sobre el nivel del mar.</translation>
    </message>
    <message>
      <source>Polygons of the model</source>
      <translation>Polígonos del modelo</translation>
    </message>
    <message>
      <source>Layer of bodies for the model polygons, with the fields density (g/cm³), base and top (m above sea level); in any coordinate reference system. Later ones replace earlier ones.</source>
      <translation>Capa de cuerpos para el modelo polygons, con los campos density (g/cm³), base y top (m sobre el nivel del mar); en cualquier sistema de referencia de coordenadas. Los posteriores reemplazan a los anteriores.</translation>
    </message>
    <message>
      <source>Days of counting</source>
      <translation>Días de conteo</translation>
    </message>
    <message>
      <source>Give the days that each station counts, above 0.</source>
      <translation>Indique los días que cuenta cada estación, mayor que 0.</translation>
    </message>
    <message>
      <source>Give the acceptance of one pixel in cm² sr, above 0. Counts grow with it and with the days.</source>
      <translation>Indique la aceptancia de un píxel en cm² sr, mayor que 0. Los conteos crecen con ella y con los días.</translation>
    </message>
    <message>
      <source>Counting noise</source>
      <translation>Ruido de conteo</translation>
    </message>
    <message>
      <source>Whether muons are counted. If not, every opacity is known, with the error given below: what the geometry alone can show.</source>
      <translation>Si se cuentan muones. Si no, se conoce cada opacidad, con el error indicado abajo: lo que puede mostrar la geometría sola.</translation>
    </message>
    <message>
      <source>Merge pixels up to this many counts</source>
      <translation>Agrupar píxeles hasta este número de conteos</translation>
    </message>
    <message>
      <source>Give the counts up to which neighbouring pixels are merged, 0 or more; 0 merges none. Pixels without a muon say no density, and leaving them out would make the rock look lighter than it is.</source>
      <translation>Indique los conteos hasta los cuales se agrupan píxeles vecinos, 0 o más; 0 no agrupa ninguno. Los píxeles sin ningún muon no dicen densidad, y omitirlos haría parecer la roca más ligera de lo que es.</translation>
    </message>
    <message>
      <source>Give a whole number, 0 or more; the same seed draws the same counts.</source>
      <translation>Indique un número entero, 0 o más; la misma semilla da los mismos conteos.</translation>
    </message>
    <message>
      <source>Extent of the volume (empty: where the muograms look)</source>
      <translation>Extensión del volumen (vacío: donde miran los muogramas)</translation>
    </message>
    <message>
      <source>Rectangle on the map, as text xmin,xmax,ymin,ymax [EPSG:code], on the elevation model. Empty takes the rectangle with nine tenths of the rock on the rays.</source>
      <translation>Rectángulo en el mapa, como texto xmin,xmax,ymin,ymax [EPSG:code], sobre el modelo de elevación. Vacío toma el rectángulo con nueve décimas partes de la roca en los rayos.</translation>
    </message>
    <message>
      <source>Voxel size (m, empty: by the number of voxels)</source>
      <translation>Tamaño del vóxel (m, vacío: según el número de vóxeles)</translation>
    </message>
    <message>
      <source>Give the edge of a voxel in m, above 0.</source>
      <translation>Indique el lado de un vóxel en m, mayor que 0.</translation>
    </message>
    <message>
      <source>Voxels along the longest side</source>
      <translation>Vóxeles en el lado más largo</translation>
    </message>
    <message>
      <source>Give the number of voxels along the longest side of the volume, 1 to 1000. It counts where no voxel size is given, which is then rounded up.</source>
      <translation>Indique el número de vóxeles en el lado más largo del volumen, de 1 a 1000. Cuenta si no se da un tamaño de vóxel, que entonces se redondea hacia arriba.</translation>
    </message>
    <message>
      <source>Base of the volume (m, empty: the lowest rays)</source>
      <translation>Base del volumen (m, vacío: los rayos más bajos)</translation>
    </message>
    <message>
      <source>Give the height of the volume's floor in m above sea level, below its top. Empty takes where all but the lowest 2 % of the rock on the rays is above it.</source>
      <translation>Indique la altura del piso del volumen en m sobre el nivel del mar, por debajo de su techo. Vacío toma donde queda por encima toda la roca de los rayos salvo el 2 % más bajo.</translation>
    </message>
    <message>
      <source>Top of the volume (m, empty: the highest ground)</source>
      <translation>Techo del volumen (m, vacío: el suelo más alto)</translation>
    </message>
    <message>
      <source>Give the height of the volume's ceiling in m above sea level, above its base.</source>
      <translation>Indique la altura del techo del volumen en m sobre el nivel del mar, por encima de su base.</translation>
    </message>
    <message>
      <source>Coordinate reference system (empty: the elevation model's or UTM)</source>
      <translation>Sistema de referencia de coordenadas (vacío: el del modelo de elevación o UTM)</translation>
    </message>
    <message>
      <source>Projected coordinate reference system of the volume, true to scale there. Empty takes that of the elevation model if it is one in metres, else the UTM zone.</source>
      <translation>Sistema de referencia de coordenadas proyectado del volumen, fiel a la escala en ese lugar. Vacío toma el del modelo de elevación si es uno en metros; si no, la zona UTM.</translation>
    </message>
    <message>
      <source>Voxels of air are known</source>
      <translation>Los vóxeles de aire se conocen</translation>
    </message>
    <message>
      <source>Whether rock ends at the terrain. If not, all voxels are unknown and the rays of the sky count too: the shape of the mountain is reconstructed with its density.</source>
      <translation>Si la roca termina en el terreno. Si no, todos los vóxeles son desconocidos y los rayos del cielo también cuentan: la forma de la montaña se reconstruye junto con su densidad.</translation>
    </message>
    <message>
      <source>Memory (GiB)</source>
      <translation>Memoria (GiB)</translation>
    </message>
    <message>
      <source>Give the most memory in GiB for the paths of the rays, above 0. Where they need more, they are computed anew at every step, which is slow.</source>
      <translation>Indique la memoria máxima en GiB para los recorridos de los rayos, mayor que 0. Si necesitan más, se calculan de nuevo en cada paso, lo que es lento.</translation>
    </message>
    <message>
      <source>Method</source>
      <translation>Método</translation>
    </message>
    <message>
      <source>How densities are found. art: ART (Kaczmarz); bart: ART by blocks; sart: SART; sirt: SIRT; mlem: MLEM; osem: OSEM; pml-quad: Penalised likelihood, quadratic; pml-hybrid: Penalised likelihood, hybrid; ospml-quad: Penalised likelihood by subsets, quadratic; ospml-hybrid: Penalised likelihood by subsets, hybrid; tv: Total variation; grad: Gradient descent; tikhonov: Tikhonov; lsmr: Damped LSMR; bayes: Bayesian, Gaussian prior; counts: Fit of counts, Gaussian prior and Poisson likelihood. Those of the family art and sirt follow the data alone; pml, tv, grad, tikhonov and lsmr prefer smooth models, tv with sharp edges; bayes weighs data against a prior and tells its errors; counts does so for rasters of counts, with trajectories as wide as they are and pixels without a muon.</source>
      <translation>Cómo se buscan las densidades. art: ART (Kaczmarz); bart: ART por bloques; sart: SART; sirt: SIRT; mlem: MLEM; osem: OSEM; pml-quad: verosimilitud penalizada, cuadrática; pml-hybrid: verosimilitud penalizada, híbrida; ospml-quad: verosimilitud penalizada por subconjuntos, cuadrática; ospml-hybrid: verosimilitud penalizada por subconjuntos, híbrida; tv: variación total; grad: descenso por gradiente; tikhonov: Tikhonov; lsmr: LSMR amortiguado; bayes: bayesiano, conocimiento previo gaussiano; counts: ajuste de conteos, conocimiento previo gaussiano y verosimilitud de Poisson. Los de la familia de art y sirt siguen solo los datos; pml, tv, grad, tikhonov y lsmr prefieren modelos suaves, tv con bordes nítidos; bayes pondera los datos frente a un conocimiento previo y dice sus errores; counts lo hace con rásteres de conteos, con trayectorias tan anchas como son y píxeles sin ningún muon.</translation>
    </message>
    <message>
      <source>Iterations (empty: the method's own)</source>
      <translation>Iteraciones (vacío: las propias del método)</translation>
    </message>
    <message>
      <source>Give the most iterations, 1 or more; a sweep over all rays is one. Methods that reach the data's errors or converge end sooner.</source>
      <translation>Indique el máximo de iteraciones, 1 o más; una es un barrido sobre todos los rayos. Los métodos que alcanzan los errores de los datos o convergen terminan antes.</translation>
    </message>
    <message>
      <source>Relaxation (empty: the method's own)</source>
      <translation>Relajación (vacío: la propia del método)</translation>
    </message>
    <message>
      <source>Regularisation (empty: the method's own)</source>
      <translation>Regularización (vacío: la propia del método)</translation>
    </message>
    <message>
      <source>Give the strength of the penalty on rough models of pml, ospml, tv, grad, tikhonov and lsmr, 0 or more; at 1 a step between neighbours weighs as much as the misfit of a voxel.</source>
      <translation>Indique la intensidad de la penalización de los modelos rugosos de pml, ospml, tv, grad, tikhonov y lsmr, 0 o más; con 1 un salto entre vecinos pesa tanto como el desajuste de un vóxel.</translation>
    </message>
    <message>
      <source>Reference density (g/cm³, empty: the muograms' mean)</source>
      <translation>Densidad de referencia (g/cm³, vacío: la media de los muogramas)</translation>
    </message>
    <message>
      <source>Give the density in g/cm³, above 0 and up to 30, of the rock outside the volume, of the start and of the prior.</source>
      <translation>Indique la densidad en g/cm³, mayor que 0 y hasta 30, de la roca fuera del volumen, del comienzo y del conocimiento previo.</translation>
    </message>
    <message>
      <source>Error of the opacities (%)</source>
      <translation>Error de las opacidades (%)</translation>
    </message>
    <message>
      <source>Give the standard error of opacities in % where there are no rasters of errors, 0 or more; it is at least that of a tenth of the mean opacity. 0 stands for unknown: then all rays count the same, no method stops at the errors, and bayes cannot be used.</source>
      <translation>Indique el error estándar de las opacidades en % donde no hay rásteres de errores, 0 o más; es al menos el de una décima parte de la opacidad media. 0 significa desconocido: entonces todos los rayos cuentan igual, ningún método se detiene en los errores y no se puede usar bayes.</translation>
    </message>
    <message>
      <source>Error of the path lengths (m)</source>
      <translation>Error de las longitudes de los recorridos (m)</translation>
    </message>
    <message>
      <source>Give the standard error of a ray's length in rock in m, 0 or more: what the elevation model does not show. It adds to the other errors.</source>
      <translation>Indique el error estándar de la longitud de un rayo en la roca en m, 0 o más: lo que el modelo de elevación no muestra. Se suma a los demás errores.</translation>
    </message>
    <message>
      <source>Keep densities above zero</source>
      <translation>Mantener las densidades sobre cero</translation>
    </message>
    <message>
      <source>Whether densities below zero are lifted to it; bayes does not.</source>
      <translation>Si las densidades por debajo de cero se elevan a cero; bayes no lo hace.</translation>
    </message>
    <message>
      <source>Highest density (g/cm³, empty: none)</source>
      <translation>Mayor densidad (g/cm³, vacío: ninguna)</translation>
    </message>
    <message>
      <source>Give the density in g/cm³, above 0, that none may exceed, such as that of the rock without pores; bayes knows none.</source>
      <translation>Indique la densidad en g/cm³, mayor que 0, que ninguna puede superar, como la de la roca sin poros; bayes no conoce ninguna.</translation>
    </message>
    <message>
      <source>Order of the rays</source>
      <translation>Orden de los rayos</translation>
    </message>
    <message>
      <source>interleaved: stations far apart take turns. sequential: as they come. random: drawn.</source>
      <translation>interleaved: se alternan estaciones alejadas entre sí. sequential: tal como vienen. random: al azar.</translation>
    </message>
    <message>
      <source>Subsets (empty: the method's own)</source>
      <translation>Subconjuntos (vacío: los propios del método)</translation>
    </message>
    <message>
      <source>Give the number of parts of bart, osem and ospml that the rays are dealt into, 1 or more.</source>
      <translation>Indique el número de partes de bart, osem y ospml en que se reparten los rayos, 1 o más.</translation>
    </message>
    <message>
      <source>Stop at this multiple of the errors</source>
      <translation>Detenerse a este múltiplo de los errores</translation>
    </message>
    <message>
      <source>Give the misfit, in standard errors, at which the methods without a penalty stop, 0 or more; 0 never stops.</source>
      <translation>Indique el desajuste, en errores estándar, en el que se detienen los métodos sin penalización, 0 o más; 0 nunca se detiene.</translation>
    </message>
    <message>
      <source>Density step of the hybrid penalty (g/cm³)</source>
      <translation>Salto de densidad de la penalización híbrida (g/cm³)</translation>
    </message>
    <message>
      <source>Give the step between neighbours in g/cm³, above 0, from which the penalty of pml-hybrid and ospml-hybrid grows no faster than the step.</source>
      <translation>Indique el salto entre vecinos en g/cm³, mayor que 0, a partir del cual la penalización de pml-hybrid y ospml-hybrid no crece más rápido que el salto.</translation>
    </message>
    <message>
      <source>Standard deviation of the prior (g/cm³)</source>
      <translation>Desviación estándar del conocimiento previo (g/cm³)</translation>
    </message>
    <message>
      <source>Give how far densities are from the reference before any muon, in g/cm³, above 0; for bayes and counts.</source>
      <translation>Indique cuánto se apartan las densidades de la referencia antes de cualquier muon, en g/cm³, mayor que 0; para bayes y counts.</translation>
    </message>
    <message>
      <source>Correlation length of the prior (m)</source>
      <translation>Longitud de correlación del conocimiento previo (m)</translation>
    </message>
    <message>
      <source>Give the distance in m, above 0, over which densities are alike; for bayes and counts.</source>
      <translation>Indique la distancia en m, mayor que 0, en la que las densidades se parecen; para bayes y counts.</translation>
    </message>
    <message>
      <source>Draws for the error of the density</source>
      <translation>Sorteos para el error de la densidad</translation>
    </message>
    <message>
      <source>Give how often bayes solves for drawn data, 1 or more, where the error of the density is wanted from more than 2000 rays; n draws tell it to 71/√n %.</source>
      <translation>Indique cuántas veces bayes resuelve con datos sorteados, 1 o más, si se quiere el error de la densidad de más de 2000 rayos; n sorteos lo dan con un 71/√n %.</translation>
    </message>
    <message>
      <source>Error of the reference density (g/cm³)</source>
      <translation>Error de la densidad de referencia (g/cm³)</translation>
    </message>
    <message>
      <source>Give how far the mean density may be from the reference before any muon, in g/cm³, 0 or more; for counts, where it is estimated with the densities.</source>
      <translation>Indique cuánto puede apartarse la densidad media de la referencia antes de cualquier muon, en g/cm³, 0 o más; para counts, que la estima con las densidades.</translation>
    </message>
    <message>
      <source>Error of each station's counts (%)</source>
      <translation>Error de los conteos de cada estación (%)</translation>
    </message>
    <message>
      <source>Give the standard error, in %, of the factor between what a station counts and what acceptance, efficiency and days say, 0 or more; for counts, which estimate it.</source>
      <translation>Indique el error estándar, en %, del factor entre lo que cuenta una estación y lo que dicen aceptancia, eficiencia y días, 0 o más; para counts, que lo estima.</translation>
    </message>
    <message>
      <source>Error of the flux (%)</source>
      <translation>Error del flujo (%)</translation>
    </message>
    <message>
      <source>Give the standard error, in %, of the factor of the flux model that all stations share, 0 or more; for counts, which estimate it.</source>
      <translation>Indique el error estándar, en %, del factor del modelo de flujo que comparten todas las estaciones, 0 o más; para counts, que lo estima.</translation>
    </message>
    <message>
      <source>Error of the boresights (°)</source>
      <translation>Error de las direcciones de apuntado (°)</translation>
    </message>
    <message>
      <source>Give the standard error, in °, of azimuth and elevation of each boresight, 0 or more; for counts, which estimate both.</source>
      <translation>Indique el error estándar, en °, del acimut y de la elevación de cada dirección de apuntado, 0 o más; para counts, que estima ambos.</translation>
    </message>
    <message>
      <source>Error of the terrain's heights (m)</source>
      <translation>Error de las alturas del terreno (m)</translation>
    </message>
    <message>
      <source>Give the standard error of the elevation model's heights in m, 0 or more; for counts, which estimate where it is too high or too low. About 5 m for SRTM.</source>
      <translation>Indique el error estándar de las alturas del modelo de elevación en m, 0 o más; para counts, que estima dónde es demasiado alto o bajo. Unos 5 m para SRTM.</translation>
    </message>
    <message>
      <source>Distance over which terrain errors are alike (m)</source>
      <translation>Distancia en la que los errores del terreno se parecen (m)</translation>
    </message>
    <message>
      <source>Give the correlation length of the errors of the terrain's heights in m, above 0.</source>
      <translation>Indique la longitud de correlación de los errores de las alturas del terreno en m, mayor que 0.</translation>
    </message>
    <message>
      <source>Detection efficiency (%)</source>
      <translation>Eficiencia de detección (%)</translation>
    </message>
    <message>
      <source>Give the share of the muons that are counted, in %, above 0 and up to 100; for the method counts.</source>
      <translation>Indique la proporción de los muones que se cuentan, en %, mayor que 0 y hasta 100; para el método counts.</translation>
    </message>
    <message>
      <source>Surveys drawn</source>
      <translation>Campañas sorteadas</translation>
    </message>
    <message>
      <source>Give how many surveys are drawn for the verdict of the method counts, 1 to 1000; the densities are those of the first.</source>
      <translation>Indique cuántas campañas se sortean para el veredicto del método counts, de 1 a 1000; las densidades son las de la primera.</translation>
    </message>
    <message>
      <source>Density (g/cm³)</source>
      <translation>Densidad (g/cm³)</translation>
    </message>
    <message>
      <source>Density of each voxel with rock that a ray passes. A GeoTIFF on the map with a band for each elevation slice, the lowest first.</source>
      <translation>Densidad de cada vóxel con roca por el que pasa un rayo. GeoTIFF en el mapa con una banda por corte de elevación, el más bajo primero.</translation>
    </message>
    <message>
      <source>Rays per voxel</source>
      <translation>Rayos por vóxel</translation>
    </message>
    <message>
      <source>Number of rays through each voxel with rock. A GeoTIFF on the map with a band for each elevation slice, the lowest first.</source>
      <translation>Número de rayos por cada vóxel con roca. GeoTIFF en el mapa con una banda por corte de elevación, el más bajo primero.</translation>
    </message>
    <message>
      <source>Error of the density (g/cm³)</source>
      <translation>Error de la densidad (g/cm³)</translation>
    </message>
    <message>
      <source>Standard error of each density, of the methods bayes and counts. A GeoTIFF on the map with a band for each elevation slice, the lowest first.</source>
      <translation>Error estándar de cada densidad, de los métodos bayes y counts. GeoTIFF en el mapa con una banda por corte de elevación, el más bajo primero.</translation>
    </message>
    <message>
      <source>Voxels as points</source>
      <translation>Vóxeles como puntos</translation>
    </message>
    <message>
      <source>Centre of each voxel with a density as a point with height, with density, rays and, where there is one, the error: for 3-D views.</source>
      <translation>Centro de cada vóxel con densidad como punto con altura, con densidad, rayos y, si lo hay, el error: para vistas en 3D.</translation>
    </message>
    <message>
      <source>Residuals</source>
      <translation>Residuos</translation>
    </message>
    <message>
      <source>CSV: what the densities leave unexplained of each muogram.</source>
      <translation>CSV: lo que las densidades dejan sin explicar de cada muograma.</translation>
    </message>
    <message>
      <source>Density of the known model in the same voxels. A GeoTIFF on the map with a band for each elevation slice, the lowest first.</source>
      <translation>Densidad del modelo conocido en los mismos vóxeles. GeoTIFF en el mapa con una banda por corte de elevación, el más bajo primero.</translation>
    </message>
    <message>
      <source>Stations</source>
      <translation>Estaciones</translation>
    </message>
    <message>
      <source>Sites that were used, with their direction and distance to the target.</source>
      <translation>Sitios que se usaron, con su dirección y distancia al objetivo.</translation>
    </message>
    <message>
      <source>Table of errors</source>
      <translation>Tabla de errores</translation>
    </message>
    <message>
      <source>CSV: contrast, errors of the densities and of the views, and the numbers of the run.</source>
      <translation>CSV: contraste, errores de las densidades y de las vistas, y los números de la ejecución.</translation>
    </message>
    <message>
      <source>Picture of the known model, of what is found and of the error, summed from the top, the front and the side, and in slices through the target.</source>
      <translation>Figura del modelo conocido, de lo encontrado y del error, sumados desde arriba, de frente y de lado, y en cortes por el objetivo.</translation>
    </message>
    <message>
      <source>One HTML file with the panel, what is found of each body, the misfit by iteration and station, parameters, numbers, every warning and how to cite.</source>
      <translation>Un archivo HTML con el panel, lo encontrado de cada cuerpo, el desajuste por iteración y estación, parámetros, números, todas las advertencias y cómo citar.</translation>
    </message>
    <message>
      <source>Contrast found over the true one</source>
      <translation>Contraste encontrado dividido por el verdadero</translation>
    </message>
    <message>
      <source>Relative error of the densities</source>
      <translation>Error relativo de las densidades</translation>
    </message>
    <message>
      <source>Standard deviation of the errors (g/cm³)</source>
      <translation>Desviación estándar de los errores (g/cm³)</translation>
    </message>
    <message>
      <source>Mean of the errors (g/cm³)</source>
      <translation>Media de los errores (g/cm³)</translation>
    </message>
    <message>
      <source>Top view, normalised: mean |ε|</source>
      <translation>Vista superior, normalizada: media de |ε|</translation>
    </message>
    <message>
      <source>Top view, normalised: σ of |ε|</source>
      <translation>Vista superior, normalizada: σ de |ε|</translation>
    </message>
    <message>
      <source>Front view: mean |ε| (km)</source>
      <translation>Vista frontal: media de |ε| (km)</translation>
    </message>
    <message>
      <source>Front view: σ of |ε| (km)</source>
      <translation>Vista frontal: σ de |ε| (km)</translation>
    </message>
    <message>
      <source>Side view: mean |ε| (km)</source>
      <translation>Vista lateral: media de |ε| (km)</translation>
    </message>
    <message>
      <source>Side view: σ of |ε| (km)</source>
      <translation>Vista lateral: σ de |ε| (km)</translation>
    </message>
    <message>
      <source>Muons counted</source>
      <translation>Muones contados</translation>
    </message>
    <message>
      <source>Sites used</source>
      <translation>Sitios usados</translation>
    </message>
    <message>
      <source>Rays used</source>
      <translation>Rayos usados</translation>
    </message>
    <message>
      <source>Voxels with a density</source>
      <translation>Vóxeles con densidad</translation>
    </message>
    <message>
      <source>Voxels with rock that no ray passes</source>
      <translation>Vóxeles con roca por los que no pasa ningún rayo</translation>
    </message>
    <message>
      <source>Residual over data</source>
      <translation>Residuo dividido por los datos</translation>
    </message>
    <message>
      <source>Mean square of residuals over their errors</source>
      <translation>Media del cuadrado de los residuos divididos por sus errores</translation>
    </message>
    <message>
      <source>Iterations done</source>
      <translation>Iteraciones hechas</translation>
    </message>
    <message>
      <source>Standard errors of the body at its place</source>
      <translation>Errores estándar del cuerpo en su lugar</translation>
    </message>
    <message>
      <source>Standard errors of the body among all places</source>
      <translation>Errores estándar del cuerpo entre todos los lugares</translation>
    </message>
    <message>
      <source>Surveys that see the body (%)</source>
      <translation>Campañas que ven el cuerpo (%)</translation>
    </message>
    <message>
      <source>Surveys that see a body where there is none (%)</source>
      <translation>Campañas que ven un cuerpo donde no lo hay (%)</translation>
    </message>
    <message>
      <source>Standard deviation of the contrast over the surveys</source>
      <translation>Desviación estándar del contraste entre las campañas</translation>
    </message>
    <message>
      <source>Distance of the largest signal from the body (m)</source>
      <translation>Distancia de la mayor señal al cuerpo (m)</translation>
    </message>
    <message>
      <source>Where to put the telescope</source>
      <translation>Dónde poner el telescopio</translation>
    </message>
    <message>
      <source>&lt;p&gt;Tells from which of many places around a target a telescope sees it best: maps of exposure time, share of the target seen, thickness of rock, free sky and a score, the best sites, and a set of sites for several telescopes.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Dice desde cuál de muchos lugares alrededor de un objetivo lo ve mejor un telescopio: mapas de tiempo de exposición, fracción vista del objetivo, espesor de roca, cielo libre y una puntuación, los mejores sitios, y un conjunto de sitios para varios telescopios.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose an elevation model, click the target, say how far away telescopes may stand and how far apart candidates are, and run. Slope, height, roads and a mask narrow the candidates; a point layer replaces the grid.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Cómo se usa.&lt;/b&gt; Elija un modelo de elevación, haga clic en el objetivo, diga a qué distancia pueden estar los telescopios y qué separación tienen los candidatos, y ejecute. Pendiente, altura, vías y una máscara limitan los candidatos; una capa de puntos reemplaza la rejilla.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; Every candidate is a &lt;i&gt;Muon radiography&lt;/i&gt; of its own, aimed at the target. The target body is a vertical cylinder around the target, from the ground down to a depth below it, filled with points of equal volume. Each takes thickness and exposure time of the pixel in its direction, and is seen where the rock is between the thinnest and the thickest.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué hace.&lt;/b&gt; Cada candidato es una &lt;i&gt;Radiografía de muones&lt;/i&gt; propia, dirigida al objetivo. El cuerpo objetivo es un cilindro vertical alrededor del objetivo, desde el suelo hasta una profundidad, lleno de puntos de igual volumen. Cada punto toma el espesor y el tiempo de exposición del píxel en su dirección, y se ve si la roca está entre la más delgada y la más gruesa.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;The score&lt;/b&gt;, 0 to 1, is the mean over the body of T/(T + d) where it is seen and 0 elsewhere, for the T days of the campaign and the d days until the pixel has its muons. It is 1/2 where the campaign just brings the muons wanted everywhere.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;La puntuación&lt;/b&gt;, de 0 a 1, es la media sobre el cuerpo de T/(T + d) donde se ve y de 0 en el resto, para los T días de la campaña y los d días hasta que el píxel tiene sus muones. Es 1/2 donde la campaña da justo los muones deseados en todas partes.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Telescopes that go together.&lt;/b&gt; A telescope covers the azimuths around the target with its score, which falls linearly to 0 at the angle given. One after the other the site is taken that raises the mean over all azimuths most. The layer is ready for &lt;i&gt;Muograms from many sites&lt;/i&gt;.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Telescopios que se complementan.&lt;/b&gt; Un telescopio cubre los azimuts alrededor del objetivo con su puntuación, que cae linealmente a 0 en el ángulo indicado. Uno tras otro se toma el sitio que más eleva la media sobre todos los azimuts. La capa queda lista para &lt;i&gt;Muogramas desde muchos sitios&lt;/i&gt;.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Long surveys.&lt;/b&gt; All processors compute. A survey that was stopped goes on when it is run again with the same SCORE; what is finished waits in a folder beside it, named after it with &lt;i&gt;.partial&lt;/i&gt;, which is removed at the end. SCHEDULER sends the work to a Dask cluster.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Campañas largas.&lt;/b&gt; Calculan todos los procesadores. Una campaña interrumpida continúa cuando se ejecuta de nuevo con el mismo SCORE; lo terminado espera en una carpeta a su lado, con su nombre y &lt;i&gt;.partial&lt;/i&gt;, que se elimina al final. SCHEDULER envía el trabajo a un clúster de Dask.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Not seen&lt;/b&gt; is also what lies outside the field of view or behind unknown rock; the log says how much that is.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;No se ve&lt;/b&gt; tampoco lo que queda fuera del campo de visión o detrás de roca desconocida; el registro dice cuánto es.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Smallest distance to the target (m)</source>
      <translation>Menor distancia al objetivo (m)</translation>
    </message>
    <message>
      <source>Give the horizontal distance in m within which no telescope stands, 0 or more.</source>
      <translation>Indique la distancia horizontal en m dentro de la cual no hay telescopios, 0 o más.</translation>
    </message>
    <message>
      <source>Largest distance to the target (m)</source>
      <translation>Mayor distancia al objetivo (m)</translation>
    </message>
    <message>
      <source>Give the horizontal distance in m beyond which no telescope stands, above 0.</source>
      <translation>Indique la distancia horizontal en m más allá de la cual no hay telescopios, mayor que 0.</translation>
    </message>
    <message>
      <source>Spacing of candidates and maps (m)</source>
      <translation>Separación de candidatos y mapas (m)</translation>
    </message>
    <message>
      <source>Give the distance between candidates in m, above 0: also the cell size of the maps. Half of it makes four times as many candidates.</source>
      <translation>Indique la distancia entre candidatos en m, mayor que 0: también el tamaño de celda de los mapas. La mitad da cuatro veces más candidatos.</translation>
    </message>
    <message>
      <source>Steepest slope (°, 90: any)</source>
      <translation>Pendiente máxima (°, 90: cualquiera)</translation>
    </message>
    <message>
      <source>Give the steepest ground in degrees, above 0 and up to 90, measured over one cell of the DEM to each side.</source>
      <translation>Indique la mayor pendiente del suelo en grados, mayor que 0 y hasta 90, medida sobre una celda del MDE a cada lado.</translation>
    </message>
    <message>
      <source>Highest above the target (m, empty: any)</source>
      <translation>Máximo por encima del objetivo (m, vacío: cualquiera)</translation>
    </message>
    <message>
      <source>Give how much the ground at a candidate may be above the ground at the target in m; negative where it must be below.</source>
      <translation>Indique cuánto puede estar el suelo de un candidato por encima del suelo del objetivo en m; negativo si debe estar por debajo.</translation>
    </message>
    <message>
      <source>Lowest below the target (m, empty: any)</source>
      <translation>Máximo por debajo del objetivo (m, vacío: cualquiera)</translation>
    </message>
    <message>
      <source>Give how much the ground at a candidate may be below the ground at the target in m; negative where it must be above.</source>
      <translation>Indique cuánto puede estar el suelo de un candidato por debajo del suelo del objetivo en m; negativo si debe estar por encima.</translation>
    </message>
    <message>
      <source>Roads</source>
      <translation>Vías</translation>
    </message>
    <message>
      <source>Layer of lines that telescopes must be near, in any coordinate reference system.</source>
      <translation>Capa de líneas de las que deben estar cerca los telescopios, en cualquier sistema de referencia de coordenadas.</translation>
    </message>
    <message>
      <source>Largest distance to a road (m)</source>
      <translation>Mayor distancia a una vía (m)</translation>
    </message>
    <message>
      <source>Give the distance in m to the nearest road beyond which no telescope stands, above 0. It counts where ROADS is given.</source>
      <translation>Indique la distancia en m a la vía más cercana más allá de la cual no hay telescopios, mayor que 0. Cuenta si se indica ROADS.</translation>
    </message>
    <message>
      <source>Mask of candidates</source>
      <translation>Máscara de candidatos</translation>
    </message>
    <message>
      <source>Raster that says where telescopes may stand: anywhere that its first band is neither 0 nor no data. In any coordinate reference system.</source>
      <translation>Ráster que dice dónde pueden estar los telescopios: donde su primera banda no es 0 ni sin dato. En cualquier sistema de referencia de coordenadas.</translation>
    </message>
    <message>
      <source>Candidates</source>
      <translation>Candidatos</translation>
    </message>
    <message>
      <source>Layer of points to choose from, in place of a grid around the target. The limits hold for them too.</source>
      <translation>Capa de puntos entre los que se elige, en lugar de una rejilla alrededor del objetivo. Los límites valen también para ellos.</translation>
    </message>
    <message>
      <source>Radius of the target body (m)</source>
      <translation>Radio del cuerpo objetivo (m)</translation>
    </message>
    <message>
      <source>Give the radius in m of the part of the mountain that matters, above 0: a vertical cylinder around the target.</source>
      <translation>Indique el radio en m de la parte de la montaña que importa, mayor que 0: un cilindro vertical alrededor del objetivo.</translation>
    </message>
    <message>
      <source>Depth of the target body (m)</source>
      <translation>Profundidad del cuerpo objetivo (m)</translation>
    </message>
    <message>
      <source>Give how far in m below the ground at the target the target body reaches, above 0.</source>
      <translation>Indique cuánto en m por debajo del suelo del objetivo llega el cuerpo objetivo, mayor que 0.</translation>
    </message>
    <message>
      <source>Thinnest rock to see through (m)</source>
      <translation>Roca más delgada que se atraviesa (m)</translation>
    </message>
    <message>
      <source>Give the thickness of rock in m below which a ray says nothing of the target, 0 or more.</source>
      <translation>Indique el espesor de roca en m por debajo del cual un rayo no dice nada del objetivo, 0 o más.</translation>
    </message>
    <message>
      <source>Thickest rock to see through (m)</source>
      <translation>Roca más gruesa que se atraviesa (m)</translation>
    </message>
    <message>
      <source>Give the thickness of rock in m above which too few muons come through, above the thinnest.</source>
      <translation>Indique el espesor de roca en m por encima del cual pasan muy pocos muones, mayor que el más delgado.</translation>
    </message>
    <message>
      <source>Days of the campaign</source>
      <translation>Días de la campaña</translation>
    </message>
    <message>
      <source>Give the days that telescopes will count, above 0. The score weighs exposure times against it.</source>
      <translation>Indique los días que contarán los telescopios, mayor que 0. La puntuación compara con ellos los tiempos de exposición.</translation>
    </message>
    <message>
      <source>Number of best sites</source>
      <translation>Número de mejores sitios</translation>
    </message>
    <message>
      <source>Give how many of the best candidates to list, 1 or more.</source>
      <translation>Indique cuántos de los mejores candidatos se enumeran, 1 o más.</translation>
    </message>
    <message>
      <source>Distance between best sites (m)</source>
      <translation>Distancia entre los mejores sitios (m)</translation>
    </message>
    <message>
      <source>Give how far in m the best sites are from each other at the least, 0 or more.</source>
      <translation>Indique cuánto en m distan al menos los mejores sitios entre sí, 0 o más.</translation>
    </message>
    <message>
      <source>Number of telescopes</source>
      <translation>Número de telescopios</translation>
    </message>
    <message>
      <source>Give how many telescopes are to cover the target's sides together, 1 or more.</source>
      <translation>Indique cuántos telescopios deben cubrir juntos los lados del objetivo, 1 o más.</translation>
    </message>
    <message>
      <source>Angle that a telescope covers (°, empty: 360° over their number)</source>
      <translation>Ángulo que cubre un telescopio (°, vacío: 360° divididos por su número)</translation>
    </message>
    <message>
      <source>Give the angle around the target in degrees, above 0 and up to 360, to either side of a telescope, at which it adds nothing any more.</source>
      <translation>Indique el ángulo alrededor del objetivo en grados, mayor que 0 y hasta 360, a cada lado de un telescopio, en el que ya no aporta nada.</translation>
    </message>
    <message>
      <source>Dask scheduler (empty: this machine)</source>
      <translation>Planificador de Dask (vacío: este equipo)</translation>
    </message>
    <message>
      <source>Address of the scheduler of a Dask cluster, such as tcp://10.0.0.1:8786, whose workers compute in place of this machine. It needs the Python library distributed.</source>
      <translation>Dirección del planificador de un clúster de Dask, como tcp://10.0.0.1:8786, cuyos procesos calculan en lugar de este equipo. Necesita la biblioteca de Python distributed.</translation>
    </message>
    <message>
      <source>Score</source>
      <translation>Puntuación</translation>
    </message>
    <message>
      <source>From 0 to 1: the mean over the target body of T/(T + d) where it is seen and 0 elsewhere, for T days of the campaign and d days until the pixel has its muons. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation>De 0 a 1: la media sobre el cuerpo objetivo de T/(T + d) donde se ve y de 0 en el resto, para T días de campaña y d días hasta que el píxel tiene los muones deseados. GeoTIFF en el mapa con una celda por candidato.</translation>
    </message>
    <message>
      <source>Days to the muons wanted</source>
      <translation>Días hasta los muones deseados</translation>
    </message>
    <message>
      <source>Median days, over the part of the target body that is seen, until a pixel has the muons wanted. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation>Mediana de los días, sobre la parte del cuerpo objetivo que se ve, hasta que un píxel tiene los muones deseados. GeoTIFF en el mapa con una celda por candidato.</translation>
    </message>
    <message>
      <source>Share of the target seen</source>
      <translation>Fracción vista del objetivo</translation>
    </message>
    <message>
      <source>Share of the target body's volume that is seen through rock between the thinnest and the thickest, 0 to 1. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation>Fracción del volumen del cuerpo objetivo que se ve a través de roca entre la más delgada y la más gruesa, de 0 a 1. GeoTIFF en el mapa con una celda por candidato.</translation>
    </message>
    <message>
      <source>Median thickness through the target</source>
      <translation>Mediana del espesor a través del objetivo</translation>
    </message>
    <message>
      <source>Median length in rock of the rays through the target body. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation>Mediana de la longitud en la roca de los rayos a través del cuerpo objetivo. GeoTIFF en el mapa con una celda por candidato.</translation>
    </message>
    <message>
      <source>Smallest thickness through the target</source>
      <translation>Menor espesor a través del objetivo</translation>
    </message>
    <message>
      <source>Least length in rock of the rays through the target body. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation>Menor longitud en la roca de los rayos a través del cuerpo objetivo. GeoTIFF en el mapa con una celda por candidato.</translation>
    </message>
    <message>
      <source>Largest thickness through the target</source>
      <translation>Mayor espesor a través del objetivo</translation>
    </message>
    <message>
      <source>Greatest length in rock of the rays through the target body. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation>Mayor longitud en la roca de los rayos a través del cuerpo objetivo. GeoTIFF en el mapa con una celda por candidato.</translation>
    </message>
    <message>
      <source>Share of free sky</source>
      <translation>Fracción de cielo libre</translation>
    </message>
    <message>
      <source>Share of the pixels that see only sky, 0 to 1: where the telescope is calibrated. A GeoTIFF on the map with a cell for each candidate.</source>
      <translation>Fracción de los píxeles que solo ven cielo, de 0 a 1: donde se calibra el telescopio. GeoTIFF en el mapa con una celda por candidato.</translation>
    </message>
    <message>
      <source>Best sites</source>
      <translation>Mejores sitios</translation>
    </message>
    <message>
      <source>Points of the candidates with the highest scores and their numbers, best first.</source>
      <translation>Puntos de los candidatos con las mayores puntuaciones y sus números, el mejor primero.</translation>
    </message>
    <message>
      <source>Telescopes that go together</source>
      <translation>Telescopios que se complementan</translation>
    </message>
    <message>
      <source>Points of the sites that cover the azimuths around the target best, in the order of choice: the layer of sites for Muograms from many sites.</source>
      <translation>Puntos de los sitios que mejor cubren los azimuts alrededor del objetivo, en el orden de elección: la capa de sitios para Muogramas desde muchos sitios.</translation>
    </message>
    <message>
      <source>Picture of the score on the map with the sites chosen, the azimuths around the target that the telescopes cover, and exposure times against the share seen.</source>
      <translation>Figura de la puntuación en el mapa con los sitios elegidos, los azimuts alrededor del objetivo que cubren los telescopios, y los tiempos de exposición frente a la fracción vista.</translation>
    </message>
    <message>
      <source>Candidates that see a part of the target</source>
      <translation>Candidatos que ven una parte del objetivo</translation>
    </message>
    <message>
      <source>Highest score</source>
      <translation>Mayor puntuación</translation>
    </message>
    <message>
      <source>Days to the muons wanted at the best site</source>
      <translation>Días hasta los muones deseados en el mejor sitio</translation>
    </message>
    <message>
      <source>Share of the target seen from the best site</source>
      <translation>Fracción del objetivo vista desde el mejor sitio</translation>
    </message>
    <message>
      <source>Mean coverage of the azimuths by the telescopes that go together</source>
      <translation>Cobertura media de los azimuts por los telescopios que se complementan</translation>
    </message>
    <message>
      <source>Telescope parameters</source>
      <translation>Parámetros del telescopio</translation>
    </message>
    <message>
      <source>&lt;p&gt;Computes what a telescope of pixel planes collects from each of its directions: acceptance, solid angle, detection area, path length and angular resolution.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Calcula lo que un telescopio de planos de píxeles recoge desde cada una de sus direcciones: aceptancia, ángulo sólido, área de detección, longitud del recorrido y resolución angular.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;How to use it.&lt;/b&gt; Choose a telescope that was built, or &lt;i&gt;custom&lt;/i&gt; and give the number of bars, their width and the separation of the planes. A preset wins over numbers of your own.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Cómo se usa.&lt;/b&gt; Elija un telescopio que se construyó, o &lt;i&gt;custom&lt;/i&gt; e indique el número de barras, su ancho y la separación de los planos. Un telescopio de la lista prevalece sobre los números propios.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; A muon is known by its pixel in the front plane and its pixel in the back plane. Pairs of pixels with the same offset look the same way and make one trajectory: (2N − 1)² of them for N × N bars. The formula &lt;i&gt;exact&lt;/i&gt; integrates over both pixels, so that all trajectories together collect what the two whole planes do; &lt;i&gt;paper&lt;/i&gt; is the one that MUYSC was published with. Planes in between change nothing.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué hace.&lt;/b&gt; Un muon se conoce por su píxel en el plano delantero y su píxel en el plano trasero. Los pares de píxeles con el mismo desplazamiento miran en la misma dirección y forman una trayectoria: (2N − 1)² para N × N barras. La fórmula &lt;i&gt;exact&lt;/i&gt; integra sobre ambos píxeles, de modo que todas las trayectorias juntas recogen lo que los dos planos enteros; &lt;i&gt;paper&lt;/i&gt; es aquella con la que se publicó MUYSC. Los planos intermedios no cambian nada.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;The rasters&lt;/b&gt; have the tangent of the angle from the boresight as axes, the telescope's right as x and its up as y: one pixel is the width of a bar over the separation, everywhere.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Los rásteres&lt;/b&gt; tienen como ejes la tangente del ángulo desde el eje del telescopio, con su derecha como x y su arriba como y: un píxel es el ancho de una barra dividido por la separación, en todas partes.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Solid angle (sr)</source>
      <translation>Ángulo sólido (sr)</translation>
    </message>
    <message>
      <source>Solid angle of the directions that belong to each trajectory. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Ángulo sólido de las direcciones que pertenecen a cada trayectoria. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Detection area (cm²)</source>
      <translation>Área de detección (cm²)</translation>
    </message>
    <message>
      <source>Area of the front plane from which each trajectory reaches the back plane. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Área del plano delantero desde la que cada trayectoria alcanza el plano trasero. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Path between the planes (cm)</source>
      <translation>Recorrido entre los planos (cm)</translation>
    </message>
    <message>
      <source>Length from plane to plane along each trajectory. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Longitud de plano a plano a lo largo de cada trayectoria. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Angular resolution (mrad)</source>
      <translation>Resolución angular (mrad)</translation>
    </message>
    <message>
      <source>Square root of the solid angle: the full width of the response. A GeoTIFF with the telescope's right to the right and its up upwards, as tangents of the angle from the boresight.</source>
      <translation>Raíz cuadrada del ángulo sólido: el ancho total de la respuesta. GeoTIFF con la derecha del telescopio hacia la derecha y su arriba hacia arriba, como tangentes del ángulo desde el eje.</translation>
    </message>
    <message>
      <source>Picture of the telescope and its aperture, with acceptance, solid angle, detection area and path length as maps and sections.</source>
      <translation>Figura del telescopio y su apertura, con aceptancia, ángulo sólido, área de detección y longitud del recorrido como mapas y secciones.</translation>
    </message>
    <message>
      <source>Comparison</source>
      <translation>Comparación</translation>
    </message>
    <message>
      <source>Picture of this telescope beside all that were built.</source>
      <translation>Figura de este telescopio junto a todos los que se construyeron.</translation>
    </message>
    <message>
      <source>One HTML file with figures, parameters, numbers and how to cite.</source>
      <translation>Un archivo HTML con figuras, parámetros, números y cómo citar.</translation>
    </message>
    <message>
      <source>Largest acceptance of a trajectory (cm² sr)</source>
      <translation>Mayor aceptancia de una trayectoria (cm² sr)</translation>
    </message>
    <message>
      <source>Largest solid angle of a trajectory (sr)</source>
      <translation>Mayor ángulo sólido de una trayectoria (sr)</translation>
    </message>
    <message>
      <source>Largest detection area (cm²)</source>
      <translation>Mayor área de detección (cm²)</translation>
    </message>
    <message>
      <source>Half aperture across (°)</source>
      <translation>Semiapertura a lo ancho (°)</translation>
    </message>
    <message>
      <source>Half aperture up (°)</source>
      <translation>Semiapertura a lo alto (°)</translation>
    </message>
    <message>
      <source>Angle from one trajectory to the next (mrad)</source>
      <translation>Ángulo de una trayectoria a la siguiente (mrad)</translation>
    </message>
    <message>
      <source>Trajectories</source>
      <translation>Trayectorias</translation>
    </message>
    <message>
      <source>Étendue, all acceptances together (cm² sr)</source>
      <translation>Étendue, todas las aceptancias juntas (cm² sr)</translation>
    </message>
    <message>
      <source>Muon tomography</source>
      <translation>Tomografía de muones</translation>
    </message>
    <message>
      <source>&lt;p&gt;Finds the density of the rock in three dimensions from muograms of several stations.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Busca la densidad de la roca en tres dimensiones a partir de muogramas de varias estaciones.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What you need.&lt;/b&gt; Muograms of one quantity, and the elevation model they were seen on. &lt;b&gt;Density&lt;/b&gt; (from &lt;i&gt;Density from a measured muogram&lt;/i&gt;), &lt;b&gt;opacity&lt;/b&gt;, &lt;b&gt;flux&lt;/b&gt; or &lt;b&gt;transmission&lt;/b&gt; show the inside of the mountain; flux and transmission are turned into opacity with the physics that the files name. &lt;b&gt;Thickness&lt;/b&gt; shows its shape alone. Rasters of errors are found by detector and directions. Without them an error in percent is assumed. The more sides the stations look from, the better: one station alone cannot tell near rock from far.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué se necesita.&lt;/b&gt; Muogramas de una misma magnitud, y el modelo de elevación sobre el que se vieron. La &lt;b&gt;densidad&lt;/b&gt; (de &lt;i&gt;Densidad a partir de un muograma medido&lt;/i&gt;), la &lt;b&gt;opacidad&lt;/b&gt;, el &lt;b&gt;flujo&lt;/b&gt; o la &lt;b&gt;transmisión&lt;/b&gt; muestran el interior de la montaña; flujo y transmisión se convierten en opacidad con la física que nombran los archivos. El &lt;b&gt;espesor&lt;/b&gt; muestra solo su forma. Los rásteres de errores se reconocen por detector y direcciones. Sin ellos se supone un error en porcentaje. Cuantos más lados miren las estaciones, mejor: una estación sola no distingue la roca cercana de la lejana.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Counts.&lt;/b&gt; Rasters of &lt;b&gt;counts&lt;/b&gt; are fitted as they are (method &lt;i&gt;counts&lt;/i&gt;): each trajectory as wide as it is, with its telescope, days and efficiency from the file, and pixels without a muon as data. What is not known exactly is estimated with the densities, and told with its error: a factor for each station and for the flux, the mean density, each boresight, and the heights of the terrain. This is the way from a telescope to densities; densities of single pixels lose what the thin part of a wide trajectory lets through. Other methods do not read counts.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Conteos.&lt;/b&gt; Los rásteres de &lt;b&gt;conteos&lt;/b&gt; se ajustan tal como son (método &lt;i&gt;counts&lt;/i&gt;): cada trayectoria tan ancha como es, con el telescopio, los días y la eficiencia del archivo, y los píxeles sin ningún muon como datos. Lo que no se conoce exactamente se estima con las densidades y se dice con su error: un factor por estación y otro del flujo, la densidad media, cada dirección de apuntado y las alturas del terreno. Este es el camino de un telescopio a las densidades; las densidades de píxeles sueltos pierden lo que deja pasar la parte delgada de una trayectoria ancha. Los demás métodos no leen conteos.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; With counts, straight sub-rays fill each trajectory; of other quantities, each pixel is one straight ray along its middle, so that pixels wider than a voxel blur the result. Its lengths in the voxels are exact, cut off where the terrain begins and ends, with the Earth's curvature and the true north and scale of the projection. Voxels of air are no unknowns. Rock on the ray outside the volume is taken off at the reference density. Then the method finds the densities whose integrals along the rays are the opacities.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué hace.&lt;/b&gt; Con conteos, subrayos rectos llenan cada trayectoria; con otras magnitudes, cada píxel es un rayo recto por su centro, así que los píxeles más anchos que un vóxel desdibujan el resultado. Sus longitudes en los vóxeles son exactas, cortadas donde el terreno comienza y termina, con la curvatura de la Tierra y el norte y la escala verdaderos de la proyección. Los vóxeles de aire no son incógnitas. La roca del rayo fuera del volumen se descuenta con la densidad de referencia. Luego el método busca las densidades cuyas integrales a lo largo de los rayos son las opacidades.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Which method.&lt;/b&gt; &lt;i&gt;bayes&lt;/i&gt; (default) weighs the data by their errors against a prior about the reference density: where rays say little, the density stays near it. It tells the error of each density. &lt;i&gt;tv&lt;/i&gt; prefers bodies with sharp edges; its regularisation must suit the noise. &lt;i&gt;sirt&lt;/i&gt;, &lt;i&gt;art&lt;/i&gt;, &lt;i&gt;sart&lt;/i&gt;, &lt;i&gt;mlem&lt;/i&gt; and their relatives follow the data and stop at their errors. Filtered back-projection and Gridrec need parallel rays and are refused.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué método.&lt;/b&gt; &lt;i&gt;bayes&lt;/i&gt; (predeterminado) pondera los datos por sus errores frente a un conocimiento previo en torno a la densidad de referencia: donde los rayos dicen poco, la densidad queda cerca de ella. Dice el error de cada densidad. &lt;i&gt;tv&lt;/i&gt; prefiere cuerpos con bordes nítidos; su regularización debe ajustarse al ruido. &lt;i&gt;sirt&lt;/i&gt;, &lt;i&gt;art&lt;/i&gt;, &lt;i&gt;sart&lt;/i&gt;, &lt;i&gt;mlem&lt;/i&gt; y sus parientes siguen los datos y se detienen en sus errores. La retroproyección filtrada y Gridrec necesitan rayos paralelos y se rechazan.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;The volume.&lt;/b&gt; Without an extent, it is where the muograms look. Voxels much smaller than the distance between rays cost memory and show nothing. Where the paths do not fit the memory, they are computed anew at each step.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;El volumen.&lt;/b&gt; Sin una extensión, está donde miran los muogramas. Los vóxeles mucho menores que la distancia entre rayos cuestan memoria y no muestran nada. Si los recorridos no caben en la memoria, se calculan de nuevo en cada paso.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What comes out.&lt;/b&gt; &lt;i&gt;Density&lt;/i&gt;, &lt;i&gt;rays per voxel&lt;/i&gt; and &lt;i&gt;error of the density&lt;/i&gt; are GeoTIFFs on the map with a band for each elevation slice, the lowest first; each band is named after the height of its centre. The slice of the target is shown first. From QGIS 3.38 on, the elevation controller steps through them. Voxels in air and those that no ray passes have no data; they and the pixels that were not used are counted in the log, by cause.&lt;/p&gt;</source>
      <translation>&lt;p&gt;&lt;b&gt;Qué resulta.&lt;/b&gt; &lt;i&gt;Densidad&lt;/i&gt;, &lt;i&gt;rayos por vóxel&lt;/i&gt; y &lt;i&gt;error de la densidad&lt;/i&gt; son GeoTIFF en el mapa con una banda por corte de elevación, el más bajo primero; cada banda lleva el nombre de la altura de su centro. Primero se muestra el corte del objetivo. Desde QGIS 3.38 el controlador de elevación los recorre. Los vóxeles en el aire y aquellos por los que no pasa ningún rayo quedan sin dato; ellos y los píxeles que no se usaron se cuentan en el registro, según la causa.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Residuals&lt;/b&gt; tell for each muogram what the densities leave unexplained. Chi squared per ray is about 1 where model and errors are right. Much more means that errors are too small, or that muograms contradict each other.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Los &lt;b&gt;residuos&lt;/b&gt; dicen para cada muograma lo que las densidades dejan sin explicar. Chi cuadrado por rayo es aproximadamente 1 donde el modelo y los errores son correctos. Mucho más significa que los errores son demasiado pequeños, o que los muogramas se contradicen.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Residual muograms&lt;/b&gt; and &lt;b&gt;factors&lt;/b&gt; show where counts are not explained: noise of size 1 everywhere is a perfect fit. A warning says so where chi squared is above 1.5, a density is that of no rock, or a factor or a boresight is far from what was known, with the cause and what to do.&lt;/p&gt;</source>
      <translation>&lt;p&gt;Los &lt;b&gt;muogramas de residuos&lt;/b&gt; y los &lt;b&gt;factores&lt;/b&gt; muestran dónde los conteos no quedan explicados: ruido de tamaño 1 en todas partes es un ajuste perfecto. Una advertencia lo dice donde chi cuadrado supera 1.5, una densidad no es la de ninguna roca, o un factor o una dirección de apuntado están lejos de lo que se sabía, con la causa y qué hacer.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Muograms</source>
      <translation>Muogramas</translation>
    </message>
    <message>
      <source>Muograms of one quantity from several stations: counts, density, opacity, flux, transmission or thickness, or rasters in telescope angles. They say themselves what they hold and where their detectors stand; counts also say the days, and telescope or acceptance.</source>
      <translation>Muogramas de una misma magnitud desde varias estaciones: conteos, densidad, opacidad, flujo, transmisión o espesor, o rásteres en ángulos del telescopio. Ellos mismos dicen qué contienen y dónde están sus detectores; los conteos dicen además los días, y el telescopio o la aceptancia.</translation>
    </message>
    <message>
      <source>Errors of the muograms</source>
      <translation>Errores de los muogramas</translation>
    </message>
    <message>
      <source>Rasters of the standard errors, such as density error, one for each muogram, in any order: they are matched by detector and directions.</source>
      <translation>Rásteres de los errores estándar, como el error de la densidad, uno por muograma, en cualquier orden: se asocian por detector y direcciones.</translation>
    </message>
    <message>
      <source>Acceptances of the counts</source>
      <translation>Aceptancias de los conteos</translation>
    </message>
    <message>
      <source>Rasters of acceptances in cm² sr on the pixels of counts, in any order; without one, that of the telescope or of the metadata (ACCEPTANCE) counts.</source>
      <translation>Rásteres de aceptancias en cm² sr en los píxeles de los conteos, en cualquier orden; sin uno, vale la del telescopio o la de los metadatos (ACCEPTANCE).</translation>
    </message>
    <message>
      <source>Line of a vertical section</source>
      <translation>Línea de una sección vertical</translation>
    </message>
    <message>
      <source>Layer whose first line says where the vertical section runs; in any coordinate reference system.</source>
      <translation>Capa cuya primera línea dice por dónde pasa la sección vertical; en cualquier sistema de referencia de coordenadas.</translation>
    </message>
    <message>
      <source>Factors and boresights</source>
      <translation>Factores y direcciones de apuntado</translation>
    </message>
    <message>
      <source>CSV, of the method counts: mean density, factor of the flux, and factor and boresight of each station, with what was known before and the errors of both.</source>
      <translation>CSV, del método counts: densidad media, factor del flujo, y factor y dirección de apuntado de cada estación, con lo que se sabía antes y los errores de ambos.</translation>
    </message>
    <message>
      <source>Folder of residual muograms</source>
      <translation>Carpeta de muogramas de residuos</translation>
    </message>
    <message>
      <source>Holds a GeoTIFF for each raster of counts, of the method counts: counts less what the densities expect, over the standard error; noise of size 1 where all is explained.</source>
      <translation>Contiene un GeoTIFF por ráster de conteos, del método counts: conteos menos lo que esperan las densidades, divididos por el error estándar; ruido de tamaño 1 donde todo está explicado.</translation>
    </message>
    <message>
      <source>Vertical section</source>
      <translation>Sección vertical</translation>
    </message>
    <message>
      <source>Picture of the densities below the line, with the ground.</source>
      <translation>Figura de las densidades bajo la línea, con el suelo.</translation>
    </message>
    <message>
      <source>Picture of slices and sections through the target, views from the top, the front and the side, and the rays per voxel, with a map of the stations.</source>
      <translation>Figura de cortes y secciones por el objetivo, vistas desde arriba, de frente y de lado, y los rayos por vóxel, con un mapa de las estaciones.</translation>
    </message>
    <message>
      <source>One HTML file with the panel, the misfit by iteration and station, parameters, numbers, every warning and how to cite.</source>
      <translation>Un archivo HTML con el panel, el desajuste por iteración y estación, parámetros, números, todas las advertencias y cómo citar.</translation>
    </message>
    <message>
      <source>Mean density of the voxels (g/cm³)</source>
      <translation>Densidad media de los vóxeles (g/cm³)</translation>
    </message>
    <message>
      <source>Reference density used (g/cm³)</source>
      <translation>Densidad de referencia usada (g/cm³)</translation>
    </message>
    <message>
      <source>Volcano survey</source>
      <translation>Campaña en un volcán</translation>
    </message>
    <message>
      <source>&lt;p&gt;From an elevation model, a detector and a target to maps: simulates the muograms of the field of view and drapes thickness and flux on the terrain that the detector sees. All layers arrive with their colours, and the report tells the rest.&lt;/p&gt;</source>
      <translation>&lt;p&gt;De un modelo de elevación, un detector y un objetivo a los mapas: simula los muogramas del campo de visión y proyecta espesor y flujo sobre el terreno que ve el detector. Todas las capas llegan con sus colores, y el informe dice el resto.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Muon flux on the terrain</source>
      <translation>Flujo de muones sobre el terreno</translation>
    </message>
    <message>
      <source>Muon flux</source>
      <translation>Flujo de muones</translation>
    </message>
    <message>
      <source>Rock thickness</source>
      <translation>Espesor de roca</translation>
    </message>
    <message>
      <source>Rock thickness on the terrain</source>
      <translation>Espesor de roca sobre el terreno</translation>
    </message>
    <message>
      <source>The muogram cannot be computed ({error}); choose other values.</source>
      <translation>No se puede calcular el muograma ({error}); elija otros valores.</translation>
    </message>
    <message>
      <source>Plan a muon telescope</source>
      <translation>Planear un telescopio de muones</translation>
    </message>
    <message>
      <source>The command is on the clipboard; its files appear where it is run.</source>
      <translation>El comando está en el portapapeles; sus archivos aparecen donde se ejecute.</translation>
    </message>
    <message>
      <source>Candidate sites</source>
      <translation>Sitios candidatos</translation>
    </message>
    <message>
      <source>Run…</source>
      <translation>Ejecutar…</translation>
    </message>
    <message>
      <source>Open the Processing dialog with these values</source>
      <translation>Abrir el diálogo de Procesos con estos valores</translation>
    </message>
    <message>
      <source>Copy as command</source>
      <translation>Copiar como comando</translation>
    </message>
    <message>
      <source>A qgis_process line that computes the same in a terminal</source>
      <translation>Una línea de qgis_process que calcula lo mismo en una terminal</translation>
    </message>
    <message>
      <source>The command is on the clipboard; it reads the DEM in the system of its file, {own}, in place of {given}: assign that to the file first.</source>
      <translation>El comando está en el portapapeles; lee el MDE en el sistema de su archivo, {own}, en lugar de {given}: asigne antes este al archivo.</translation>
    </message>
    <message>
      <source>Copy picture</source>
      <translation>Copiar imagen</translation>
    </message>
    <message>
      <source>Save picture…</source>
      <translation>Guardar imagen…</translation>
    </message>
    <message>
      <source>Notes ({number})</source>
      <translation>Notas ({number})</translation>
    </message>
    <message>
      <source>Azimuth from north (°)</source>
      <translation>Azimut desde el norte (°)</translation>
    </message>
    <message>
      <source>Elevation (°)</source>
      <translation>Elevación (°)</translation>
    </message>
    <message>
      <source>open sky</source>
      <translation>cielo abierto</translation>
    </message>
    <message>
      <source>unknown</source>
      <translation>desconocido</translation>
    </message>
    <message>
      <source>Save picture</source>
      <translation>Guardar imagen</translation>
    </message>
    <message>
      <source>{path} cannot be written; choose another folder or close the file.</source>
      <translation>No se puede escribir {path}; elija otra carpeta o cierre el archivo.</translation>
    </message>
    <message>
      <source>Choose an elevation model (DEM); add one to the project if there is none.</source>
      <translation>Elija un modelo de elevación (MDE); agregue uno al proyecto si no hay ninguno.</translation>
    </message>
    <message>
      <source>Pick the detector: press the button and click where the telescope stands.</source>
      <translation>Marque el detector: pulse el botón y haga clic donde está el telescopio.</translation>
    </message>
    <message>
      <source>Pick the target: press the button and click what the telescope points at.</source>
      <translation>Marque el objetivo: pulse el botón y haga clic en aquello a lo que apunta el telescopio.</translation>
    </message>
    <message>
      <source>Open sky</source>
      <translation>Cielo abierto</translation>
    </message>
    <message>
      <source>Rock {thickness}</source>
      <translation>Roca {thickness}</translation>
    </message>
    <message>
      <source>Azimuth {angle}°</source>
      <translation>Azimut {angle}°</translation>
    </message>
    <message>
      <source>Elevation {angle}°</source>
      <translation>Elevación {angle}°</translation>
    </message>
    <message>
      <source>Opacity {opacity}</source>
      <translation>Opacidad {opacity}</translation>
    </message>
    <message>
      <source>Zenith {angle}°</source>
      <translation>Cenit {angle}°</translation>
    </message>
    <message>
      <source>Exposure {exposure}</source>
      <translation>Exposición {exposure}</translation>
    </message>
    <message>
      <source>Target {distance} away, azimuth {azimuth}°, elevation {elevation}°</source>
      <translation>Objetivo a {distance}, azimut {azimuth}°, elevación {elevation}°</translation>
    </message>
    <message>
      <source>Flux {flux}</source>
      <translation>Flujo {flux}</translation>
    </message>
    <message>
      <source>Up to {thickness} of rock, median exposure {exposure}</source>
      <translation>Hasta {thickness} de roca, mediana de la exposición {exposure}</translation>
    </message>
    <message>
      <source>Section along a ray</source>
      <translation>Sección a lo largo de un rayo</translation>
    </message>
    <message>
      <source>through the pixel</source>
      <translation>por el píxel</translation>
    </message>
    <message>
      <source>Section along azimuth {azimuth}</source>
      <translation>Sección en el azimut {azimuth}</translation>
    </message>
    <message>
      <source>Choose an elevation model</source>
      <translation>Elija un modelo de elevación</translation>
    </message>
    <message>
      <source>Raster of terrain heights that holds detector, target and rock</source>
      <translation>Ráster de alturas del terreno que contiene detector, objetivo y roca</translation>
    </message>
    <message>
      <source>Pick detector</source>
      <translation>Marcar detector</translation>
    </message>
    <message>
      <source>Click on the map where the telescope stands, or drag its marker</source>
      <translation>Haga clic en el mapa donde está el telescopio, o arrastre su marca</translation>
    </message>
    <message>
      <source>Pick target</source>
      <translation>Marcar objetivo</translation>
    </message>
    <message>
      <source>Click on the map what the telescope points at, or drag its marker</source>
      <translation>Haga clic en el mapa en aquello a lo que apunta el telescopio, o arrastre su marca</translation>
    </message>
    <message>
      <source>Height of the detector above ground, negative below</source>
      <translation>Altura del detector sobre el suelo, negativa por debajo</translation>
    </message>
    <message>
      <source>Height of the target above ground, negative inside</source>
      <translation>Altura del objetivo sobre el suelo, negativa dentro</translation>
    </message>
    <message>
      <source>Full width of the field of view in azimuth</source>
      <translation>Ancho total del campo de visión en azimut</translation>
    </message>
    <message>
      <source>Full height of the field of view in elevation</source>
      <translation>Altura total del campo de visión en elevación</translation>
    </message>
    <message>
      <source>as material</source>
      <translation>la del material</translation>
    </message>
    <message>
      <source>Acceptance of one pixel; a telescope has its own</source>
      <translation>Aceptancia de un píxel; un telescopio tiene la suya</translation>
    </message>
    <message>
      <source> per pixel</source>
      <translation> por píxel</translation>
    </message>
    <message>
      <source>Number of muons that the exposure time is for</source>
      <translation>Número de muones para el que vale el tiempo de exposición</translation>
    </message>
    <message>
      <source> days</source>
      <translation> días</translation>
    </message>
    <message>
      <source>Time of counting that the muon counts are for</source>
      <translation>Tiempo de conteo para el que valen los conteos de muones</translation>
    </message>
    <message>
      <source>DEM</source>
      <translation>MDE</translation>
    </message>
    <message>
      <source>Above ground</source>
      <translation>Sobre el suelo</translation>
    </message>
    <message>
      <source>Rock, muons and time</source>
      <translation>Roca, muones y tiempo</translation>
    </message>
    <message>
      <source>Free aperture</source>
      <translation>Apertura libre</translation>
    </message>
    <message>
      <source>Density</source>
      <translation>Densidad</translation>
    </message>
    <message>
      <source>Flux model</source>
      <translation>Modelo de flujo</translation>
    </message>
    <message>
      <source>Acceptance</source>
      <translation>Aceptancia</translation>
    </message>
    <message>
      <source>Muons</source>
      <translation>Muones</translation>
    </message>
    <message>
      <source>Counting time</source>
      <translation>Tiempo de conteo</translation>
    </message>
    <message>
      <source>Site {number}</source>
      <translation>Sitio {number}</translation>
    </message>
    <message>
      <source>The layer {name} cannot be changed; save it as a GeoPackage.</source>
      <translation>No se puede cambiar la capa {name}; guárdela como GeoPackage.</translation>
    </message>
    <message>
      <source>Days: until the pixel towards the target has {muons} muons.</source>
      <translation>Días: hasta que el píxel hacia el objetivo tiene {muons} muones.</translation>
    </message>
    <message>
      <source>Being computed</source>
      <translation>En cálculo</translation>
    </message>
    <message>
      <source>Add the detector as a site</source>
      <translation>Agregar el detector como sitio</translation>
    </message>
    <message>
      <source>Use the site as detector</source>
      <translation>Usar el sitio como detector</translation>
    </message>
    <message>
      <source>Zoom to the site</source>
      <translation>Acercar al sitio</translation>
    </message>
    <message>
      <source>Remove the sites chosen</source>
      <translation>Quitar los sitios elegidos</translation>
    </message>
    <message>
      <source>Pick a detector and add it here to compare places.</source>
      <translation>Marque un detector y agréguelo aquí para comparar lugares.</translation>
    </message>
    <message>
      <source>Distance of the target {distance}
Largest thickness {thickness}
Rock towards the target {rock}
Pixels unknown {unknown} of {pixels}</source>
      <translation>Distancia al objetivo {distance}
Mayor espesor {thickness}
Roca hacia el objetivo {rock}
Píxeles desconocidos {unknown} de {pixels}</translation>
    </message>
    <message>
      <source>Site</source>
      <translation>Sitio</translation>
    </message>
    <message>
      <source>Name; press F2 to change it</source>
      <translation>Nombre; pulse F2 para cambiarlo</translation>
    </message>
    <message>
      <source>Away (m)</source>
      <translation>Distancia (m)</translation>
    </message>
    <message>
      <source>Horizontal distance of the target</source>
      <translation>Distancia horizontal al objetivo</translation>
    </message>
    <message>
      <source>Rock (m)</source>
      <translation>Roca (m)</translation>
    </message>
    <message>
      <source>Largest thickness in the field of view</source>
      <translation>Mayor espesor en el campo de visión</translation>
    </message>
    <message>
      <source>Days</source>
      <translation>Días</translation>
    </message>
    <message>
      <source>Time until the pixel towards the target has its muons</source>
      <translation>Tiempo hasta que el píxel hacia el objetivo tiene sus muones</translation>
    </message>
    <message>
      <source>{number} days</source>
      <translation>{number} días</translation>
    </message>
    <message>
      <source>Opacity</source>
      <translation>Opacidad</translation>
    </message>
    <message>
      <source>Minimum muon energy</source>
      <translation>Energía mínima de los muones</translation>
    </message>
    <message>
      <source>Open-sky muon flux</source>
      <translation>Flujo de muones a cielo abierto</translation>
    </message>
    <message>
      <source>Mean density</source>
      <translation>Densidad media</translation>
    </message>
    <message>
      <source>Distance to the first rock</source>
      <translation>Distancia a la primera roca</translation>
    </message>
    <message>
      <source>Error of the rock thickness</source>
      <translation>Error del espesor de roca</translation>
    </message>
    <message>
      <source>Error of the opacity</source>
      <translation>Error de la opacidad</translation>
    </message>
    <message>
      <source>Error of the muon flux</source>
      <translation>Error del flujo de muones</translation>
    </message>
    <message>
      <source>Error of the transmission</source>
      <translation>Error de la transmisión</translation>
    </message>
    <message>
      <source>Error of the muon counts</source>
      <translation>Error de los conteos de muones</translation>
    </message>
    <message>
      <source>Error of the mean density</source>
      <translation>Error de la densidad media</translation>
    </message>
    <message>
      <source>Lower end of the mean density</source>
      <translation>Extremo inferior de la densidad media</translation>
    </message>
    <message>
      <source>Upper end of the mean density</source>
      <translation>Extremo superior de la densidad media</translation>
    </message>
    <message>
      <source>Smallest muon flux</source>
      <translation>Menor flujo de muones</translation>
    </message>
    <message>
      <source>Largest muon flux</source>
      <translation>Mayor flujo de muones</translation>
    </message>
    <message>
      <source>Smallest mean density</source>
      <translation>Menor densidad media</translation>
    </message>
    <message>
      <source>Largest mean density</source>
      <translation>Mayor densidad media</translation>
    </message>
    <message>
      <source>Solid angle</source>
      <translation>Ángulo sólido</translation>
    </message>
    <message>
      <source>Detection area</source>
      <translation>Área de detección</translation>
    </message>
    <message>
      <source>Path between the planes</source>
      <translation>Recorrido entre los planos</translation>
    </message>
    <message>
      <source>Angular resolution</source>
      <translation>Resolución angular</translation>
    </message>
    <message>
      <source>Counting error</source>
      <translation>Error de conteo</translation>
    </message>
    <message>
      <source>Days to see the density contrast</source>
      <translation>Días para ver el contraste de densidad</translation>
    </message>
    <message>
      <source>Residual over its error</source>
      <translation>Residuo dividido por su error</translation>
    </message>
    <message>
      <source>Score of the site</source>
      <translation>Puntuación del sitio</translation>
    </message>
    <message>
      <source>Standard rock</source>
      <translation>Roca estándar</translation>
    </message>
    <message>
      <source>Water</source>
      <translation>Agua</translation>
    </message>
    <message>
      <source>Ice</source>
      <translation>Hielo</translation>
    </message>
    <message>
      <source>Limestone (calcite)</source>
      <translation>Caliza (calcita)</translation>
    </message>
    <message>
      <source>Dolomite</source>
      <translation>Dolomita</translation>
    </message>
    <message>
      <source>Quartzite and quartz sandstone</source>
      <translation>Cuarcita y arenisca de cuarzo</translation>
    </message>
    <message>
      <source>Granite</source>
      <translation>Granito</translation>
    </message>
    <message>
      <source>Granodiorite</source>
      <translation>Granodiorita</translation>
    </message>
    <message>
      <source>Diorite</source>
      <translation>Diorita</translation>
    </message>
    <message>
      <source>Andesite</source>
      <translation>Andesita</translation>
    </message>
    <message>
      <source>Basalt</source>
      <translation>Basalto</translation>
    </message>
    <message>
      <source>Gabbro</source>
      <translation>Gabro</translation>
    </message>
    <message>
      <source>Concrete (Portland)</source>
      <translation>Hormigón (Portland)</translation>
    </message>
    <message>
      <source>Gaisser</source>
      <translation>Gaisser</translation>
    </message>
    <message>
      <source>Gaisser (MUSIC/MUSUN)</source>
      <translation>Gaisser (MUSIC/MUSUN)</translation>
    </message>
    <message>
      <source>Bugaev</source>
      <translation>Bugaev</translation>
    </message>
    <message>
      <source>Reyna–Bugaev</source>
      <translation>Reyna–Bugaev</translation>
    </message>
    <message>
      <source>Reyna–Hebbeker</source>
      <translation>Reyna–Hebbeker</translation>
    </message>
    <message>
      <source>Guan et al.</source>
      <translation>Guan et al.</translation>
    </message>
    <message>
      <source>GSF–SIBYLL</source>
      <translation>GSF–SIBYLL</translation>
    </message>
    <message>
      <source>MuTe (2020)</source>
      <translation>MuTe (2020)</translation>
    </message>
    <message>
      <source>Gibert et al. (2010)</source>
      <translation>Gibert et al. (2010)</translation>
    </message>
    <message>
      <source>Carbone et al. (2014)</source>
      <translation>Carbone et al. (2014)</translation>
    </message>
    <message>
      <source>Lo Presti et al. (2020)</source>
      <translation>Lo Presti et al. (2020)</translation>
    </message>
    <message>
      <source>Lesparre et al. (2012)</source>
      <translation>Lesparre et al. (2012)</translation>
    </message>
    <message>
      <source>Lesparre et al. (2010)</source>
      <translation>Lesparre et al. (2010)</translation>
    </message>
    <message>
      <source>Uchida et al. (2009)</source>
      <translation>Uchida et al. (2009)</translation>
    </message>
    <message>
      <source>MURAVES (2017)</source>
      <translation>MURAVES (2017)</translation>
    </message>
    <message>
      <source>Smallest density over the flux models that hold for the ray. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="vanished">Menor densidad entre los modelos de flujo válidos para el rayo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Largest density over the flux models that hold for the ray. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="vanished">Mayor densidad entre los modelos de flujo válidos para el rayo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Give the height above sea level in m, −1000 to 10000; it counts where the correction for altitude is on.</source>
      <translation type="vanished">Indique la altura sobre el nivel del mar en m, de −1000 a 10000; cuenta si la corrección por altitud está activada.</translation>
    </message>
    <message>
      <source>Smallest flux over the models that hold for the ray's energy and zenith. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="vanished">Menor flujo entre los modelos válidos para la energía y el cenit del rayo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>Largest flux over the models that hold for the ray's energy and zenith. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="vanished">Mayor flujo entre los modelos válidos para la energía y el cenit del rayo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What you need.&lt;/b&gt; A muogram of rock thickness (from &lt;i&gt;Muon radiography&lt;/i&gt;) and, on the same directions, one of: muon &lt;b&gt;counts&lt;/b&gt; with exposure and acceptance; counts with those of the same telescope in the &lt;b&gt;open sky&lt;/b&gt;, so that acceptance and efficiency drop out, wherever in the sky it pointed; a measured &lt;b&gt;flux&lt;/b&gt;; or a measured &lt;b&gt;transmission&lt;/b&gt;. &lt;i&gt;Import muogram&lt;/i&gt; reads all of them from text.&lt;/p&gt;</source>
      <translation type="vanished">&lt;p&gt;&lt;b&gt;Qué se necesita.&lt;/b&gt; Un muograma del espesor de roca (de &lt;i&gt;Radiografía de muones&lt;/i&gt;) y, en las mismas direcciones, uno de estos: &lt;b&gt;conteos&lt;/b&gt; de muones con exposición y aceptancia; conteos junto con los del mismo telescopio a &lt;b&gt;cielo abierto&lt;/b&gt;, de modo que la aceptancia y la eficiencia se cancelan, sin importar a qué parte del cielo apuntaba; un &lt;b&gt;flujo&lt;/b&gt; medido; o una &lt;b&gt;transmisión&lt;/b&gt; medida. &lt;i&gt;Importar muograma&lt;/i&gt; los lee todos desde texto.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;Counts in telescope angles work too, with a thickness in telescope angles as &lt;i&gt;Expected counts in a telescope&lt;/i&gt; writes it, and the acceptance of every pixel or a run in the open sky. Rasters, panel and report are then in telescope angles.&lt;/p&gt;</source>
      <translation type="vanished">&lt;p&gt;También sirven los conteos en ángulos del telescopio, con un espesor en ángulos del telescopio como lo escribe &lt;i&gt;Conteos esperados en un telescopio&lt;/i&gt;, y la aceptancia de cada píxel o una medición a cielo abierto. Los rásteres, el panel y el informe quedan entonces en ángulos del telescopio.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Merging.&lt;/b&gt; With a minimum of counts, neighbouring pixels are merged into rectangles that reach it; each has the one density that explains its counts, with the thickness of every pixel as it is.&lt;/p&gt;</source>
      <translation type="vanished">&lt;p&gt;&lt;b&gt;Agrupación.&lt;/b&gt; Con un mínimo de conteos, los píxeles vecinos se agrupan en rectángulos que lo alcanzan; cada uno tiene la única densidad que explica sus conteos, con el espesor de cada píxel tal como es.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Flags.&lt;/b&gt; 0 measured; 1 no rock, no data; 2 no muon was counted: the density is a lower limit at the confidence chosen and has no error; 3 as bright as the open sky: density 0; 4 measurement or thickness missing; 5 no density explains the flux, or the ray is at or below the horizon; 6 too little rock to stop any of the muons that count, no data.&lt;/p&gt;</source>
      <translation type="vanished">&lt;p&gt;&lt;b&gt;Indicadores.&lt;/b&gt; 0 medido; 1 sin roca, sin dato; 2 no se contó ningún muon: la densidad es un límite inferior con la confianza elegida y no tiene error; 3 tan brillante como el cielo abierto: densidad 0; 4 falta la medición o el espesor; 5 ninguna densidad explica el flujo, o el rayo está en el horizonte o debajo; 6 demasiada poca roca para detener a alguno de los muones que cuentan, sin dato.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;Mean density.&lt;/b&gt; For counts, the one density that lets through as many muons as were counted in all, pixels without a muon included; for flux and transmission, the mean weighted by the errors. The uncertainty of the flux model does not average out.&lt;/p&gt;</source>
      <translation type="vanished">&lt;p&gt;&lt;b&gt;Densidad media.&lt;/b&gt; Para conteos, la única densidad que deja pasar tantos muones como se contaron en total, incluidos los píxeles sin ningún muon; para flujo y transmisión, la media ponderada por los errores. La incertidumbre del modelo de flujo no se promedia.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Muogram of rock thickness in m, seen from the same place on the same directions.</source>
      <translation type="vanished">Muograma del espesor de roca en m, visto desde el mismo lugar en las mismas direcciones.</translation>
    </message>
    <message>
      <source>Give the counts that each region of merged pixels must reach, 0 or more. Neighbouring pixels then share one density. 20 and more make the errors symmetric.</source>
      <translation type="vanished">Indique los conteos que debe alcanzar cada región de píxeles agrupados, 0 o más. Los píxeles vecinos comparten entonces una densidad. Con 20 y más los errores son simétricos.</translation>
    </message>
    <message>
      <source>Uncertainty of the flux model (%)</source>
      <translation type="vanished">Incertidumbre del modelo de flujo (%)</translation>
    </message>
    <message>
      <source>Give the relative uncertainty of the flux in %, from 0 to below 100. It is the same for all pixels and does not average out. The models differ by 10 % to 15 % behind rock.</source>
      <translation type="vanished">Indique la incertidumbre relativa del flujo en %, desde 0 hasta menos de 100. Es la misma para todos los píxeles y no se promedia. Los modelos difieren entre 10 % y 15 % detrás de la roca.</translation>
    </message>
    <message>
      <source>Parametrised spectrum of the muons at sea level. gaisser-tang and guan hold for all energies and zenith angles; gaisser above 100/cos θ GeV and within 70° of the zenith; bugaev near the vertical; reyna-bugaev and reyna-hebbeker stretch vertical spectra to inclined muons.</source>
      <translation type="vanished">Espectro parametrizado de los muones a nivel del mar. gaisser-tang y guan valen para todas las energías y ángulos cenitales; gaisser, por encima de 100/cos θ GeV y a menos de 70° del cenit; bugaev, cerca de la vertical; reyna-bugaev y reyna-hebbeker extienden espectros verticales a muones inclinados.</translation>
    </message>
    <message>
      <source>Constants of the models gaisser and gaisser-tang; the other models do not use them.</source>
      <translation type="vanished">Constantes de los modelos gaisser y gaisser-tang; los demás modelos no las usan.</translation>
    </message>
    <message>
      <source>Whether the flux grows with the altitude of the detector. Made for momenta above 10 GeV/c and altitudes below 1 km; beyond that a warning is given.</source>
      <translation type="vanished">Si el flujo crece con la altitud del detector. Hecha para momentos por encima de 10 GeV/c y altitudes por debajo de 1 km; fuera de ahí se avisa.</translation>
    </message>
    <message>
      <source>Detection threshold (GeV)</source>
      <translation type="vanished">Umbral de detección (GeV)</translation>
    </message>
    <message>
      <source>Give the kinetic energy in GeV that a muon needs behind the rock to be detected, from 0 to below 100000. With 0 the open sky starts at 1 GeV/c.</source>
      <translation type="vanished">Indique la energía cinética en GeV que necesita un muon detrás de la roca para ser detectado, desde 0 hasta menos de 100000. Con 0 el cielo abierto comienza en 1 GeV/c.</translation>
    </message>
    <message>
      <source>0 measured, 1 no rock, 2 lower limit, 3 as bright as the open sky, 4 not measured, 5 no density explains the flux, 6 too little rock to dim it. A GeoTIFF with azimuth to the right and elevation upwards, degrees.</source>
      <translation type="vanished">0 medido, 1 sin roca, 2 límite inferior, 3 tan brillante como el cielo abierto, 4 no medido, 5 ninguna densidad explica el flujo, 6 demasiada poca roca para atenuarlo. GeoTIFF con el azimut hacia la derecha y la elevación hacia arriba, en grados.</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; The flux is that of &lt;i&gt;Muon radiography&lt;/i&gt;. Its mean over all directions that belong to a trajectory, rock and sky at the skyline alike, times the acceptance and the days gives the counts. The smallest visible contrast is the decrease of the mean density along the whole path whose counts chance would reach with the probability of the significance given; the days for a contrast follow from the same exact Poisson law, or from the feasibility formula of Lesparre et al. (2010).&lt;/p&gt;</source>
      <translation type="vanished">&lt;p&gt;&lt;b&gt;Qué hace.&lt;/b&gt; El flujo es el de &lt;i&gt;Radiografía de muones&lt;/i&gt;. Su media sobre todas las direcciones que pertenecen a una trayectoria, roca y cielo por igual en el perfil del horizonte, por la aceptancia y los días da los conteos. El menor contraste visible es la disminución de la densidad media a lo largo de todo el camino cuyos conteos alcanzaría el azar con la probabilidad de la significación indicada; los días para ver un contraste se obtienen de la misma ley exacta de Poisson, o de la fórmula de factibilidad de Lesparre et al. (2010).&lt;/p&gt;</translation>
    </message>
    <message>
      <source>Give the number of rays along a side, 1 to 50, traced for each step from one trajectory to the next. Errors fall with about its square.</source>
      <translation type="vanished">Indique el número de rayos por lado, de 1 a 50, trazados para cada paso de una trayectoria a la siguiente. Los errores disminuyen aproximadamente con su cuadrado.</translation>
    </message>
    <message>
      <source>Standard error of each density, of the method bayes. A GeoTIFF on the map with a band for each elevation slice, the lowest first.</source>
      <translation type="vanished">Error estándar de cada densidad, del método bayes. GeoTIFF en el mapa con una banda por corte de elevación, el más bajo primero.</translation>
    </message>
    <message>
      <source>&lt;p&gt;&lt;b&gt;What it does.&lt;/b&gt; Each pixel is a straight ray along its middle, so pixels wider than a voxel blur the result. Its lengths in the voxels are exact, cut off where the terrain begins and ends, with the Earth's curvature and the true north and scale of the projection. Voxels of air are no unknowns. Rock on the ray outside the volume is taken off at the reference density. Then the method finds the densities whose integrals along the rays are the opacities.&lt;/p&gt;</source>
      <translation type="vanished">&lt;p&gt;&lt;b&gt;Qué hace.&lt;/b&gt; Cada píxel es un rayo recto por su centro, así que los píxeles más anchos que un vóxel desdibujan el resultado. Sus longitudes en los vóxeles son exactas, cortadas donde el terreno comienza y termina, con la curvatura de la Tierra y el norte y la escala verdaderos de la proyección. Los vóxeles de aire no son incógnitas. La roca del rayo fuera del volumen se descuenta con la densidad de referencia. Luego el método busca las densidades cuyas integrales a lo largo de los rayos son las opacidades.&lt;/p&gt;</translation>
    </message>
    <message>
      <source>How densities are found. art: ART (Kaczmarz); bart: ART by blocks; sart: SART; sirt: SIRT; mlem: MLEM; osem: OSEM; pml-quad: Penalised likelihood, quadratic; pml-hybrid: Penalised likelihood, hybrid; ospml-quad: Penalised likelihood by subsets, quadratic; ospml-hybrid: Penalised likelihood by subsets, hybrid; tv: Total variation; grad: Gradient descent; tikhonov: Tikhonov; lsmr: Damped LSMR; bayes: Bayesian, Gaussian prior. Those of the family art and sirt follow the data alone; pml, tv, grad, tikhonov and lsmr prefer smooth models, tv with sharp edges; bayes weighs data against a prior and tells its errors.</source>
      <translation type="vanished">Cómo se buscan las densidades. art: ART (Kaczmarz); bart: ART por bloques; sart: SART; sirt: SIRT; mlem: MLEM; osem: OSEM; pml-quad: verosimilitud penalizada, cuadrática; pml-hybrid: verosimilitud penalizada, híbrida; ospml-quad: verosimilitud penalizada por subconjuntos, cuadrática; ospml-hybrid: verosimilitud penalizada por subconjuntos, híbrida; tv: variación total; grad: descenso por gradiente; tikhonov: Tikhonov; lsmr: LSMR amortiguado; bayes: bayesiano, conocimiento previo gaussiano. Los de la familia de art y sirt siguen solo los datos; pml, tv, grad, tikhonov y lsmr prefieren modelos suaves, tv con bordes nítidos; bayes pondera los datos frente a un conocimiento previo y dice sus errores.</translation>
    </message>
    <message>
      <source>Give how far densities are from the reference before any muon, in g/cm³, above 0; for bayes.</source>
      <translation type="vanished">Indique cuánto se apartan las densidades de la referencia antes de cualquier muon, en g/cm³, mayor que 0; para bayes.</translation>
    </message>
    <message>
      <source>Give the distance in m, above 0, over which densities are alike; for bayes.</source>
      <translation type="vanished">Indique la distancia en m, mayor que 0, en la que las densidades se parecen; para bayes.</translation>
    </message>
    <message>
      <source>Muograms of one quantity from several stations: density, opacity, flux, transmission or thickness, or rasters in telescope angles. They say themselves what they hold and where their detectors stand.</source>
      <translation type="vanished">Muogramas de una misma magnitud desde varias estaciones: densidad, opacidad, flujo, transmisión o espesor, o rásteres en ángulos del telescopio. Ellos mismos dicen qué contienen y dónde están sus detectores.</translation>
    </message>
  </context>
</TS>
