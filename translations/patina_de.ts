<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_US">
<context>
    <name>PanelRegistry</name>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Back side</source>
        <translation>Rückseite</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Rendern</translation>
    </message>
</context>
<context>
    <name>ViewLayer</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Back depth</source>
        <translation>Tiefe der Rückseite</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
</context>
<context>
    <name>brdfs</name>
    <message>
        <source>GGX</source>
        <translation>GGX</translation>
    </message>
    <message>
        <source>Lambert</source>
        <translation>Lambert</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Phong</source>
        <translation>Phong</translation>
    </message>
    <message>
        <source>Oren–Nayar</source>
        <translation>Oren–Nayar</translation>
    </message>
    <message>
        <source>Blinn–Phong</source>
        <translation>Blinn–Phong</translation>
    </message>
    <message>
        <source>Ward</source>
        <translation>Ward</translation>
    </message>
    <message>
        <source>Coated</source>
        <translation>Lackiert</translation>
    </message>
    <message>
        <source>Artist</source>
        <translation>Freies Modell</translation>
    </message>
</context>
<context>
    <name>drives</name>
    <message>
        <source>Diffuse colour</source>
        <translation>Diffuse Farbe</translation>
    </message>
    <message>
        <source>Specular colour</source>
        <translation>Spiegelfarbe</translation>
    </message>
    <message>
        <source>Index n</source>
        <translation>Index n</translation>
    </message>
    <message>
        <source>Extinction k</source>
        <translation>Extinktion k</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Translucency</source>
        <translation>Transluzenz</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Changes what things in a photograph with depth are made of.</source>
        <translation>Ändert, woraus Dinge in einem Foto mit Tiefe bestehen.</translation>
    </message>
    <message>
        <source>Project (.patina) or photograph to open.</source>
        <translation>Projekt (.patina) oder Foto, das geöffnet wird.</translation>
    </message>
    <message>
        <source>Part of the graphics device&apos;s name, or its index.</source>
        <translation>Teil des Namens des Grafikgeräts oder seine Nummer.</translation>
    </message>
</context>
<context>
    <name>metals</name>
    <message>
        <source>Silver</source>
        <translation>Silber</translation>
    </message>
    <message>
        <source>Gold</source>
        <translation>Gold</translation>
    </message>
    <message>
        <source>Copper</source>
        <translation>Kupfer</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>Aluminium</translation>
    </message>
    <message>
        <source>Chromium</source>
        <translation>Chrom</translation>
    </message>
    <message>
        <source>Iron</source>
        <translation>Eisen</translation>
    </message>
</context>
<context>
    <name>params</name>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>Roughness along</source>
        <translation>Rauheit längs</translation>
    </message>
    <message>
        <source>Roughness across</source>
        <translation>Rauheit quer</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Index of refraction</source>
        <translation>Brechungsindex</translation>
    </message>
    <message>
        <source>Metallic</source>
        <translation>Metallisch</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Glanz</translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <translation>Anisotropie</translation>
    </message>
    <message>
        <source>Sheen</source>
        <translation>Schimmer</translation>
    </message>
    <message>
        <source>Sheen tint</source>
        <translation>Farbe im Schimmer</translation>
    </message>
    <message>
        <source>Clear coat</source>
        <translation>Klarlack</translation>
    </message>
    <message>
        <source>Clear coat roughness</source>
        <translation>Rauheit des Klarlacks</translation>
    </message>
</context>
<context>
    <name>presets</name>
    <message>
        <source>Apple</source>
        <translation>Apfel</translation>
    </message>
    <message>
        <source>Chicken 1</source>
        <translation>Huhn 1</translation>
    </message>
    <message>
        <source>Chicken 2</source>
        <translation>Huhn 2</translation>
    </message>
    <message>
        <source>Cream</source>
        <translation>Sahne</translation>
    </message>
    <message>
        <source>Ketchup</source>
        <translation>Ketchup</translation>
    </message>
    <message>
        <source>Marble</source>
        <translation>Marmor</translation>
    </message>
    <message>
        <source>Potato</source>
        <translation>Kartoffel</translation>
    </message>
    <message>
        <source>Skimmed milk</source>
        <translation>Magermilch</translation>
    </message>
    <message>
        <source>Skin 1</source>
        <translation>Haut 1</translation>
    </message>
    <message>
        <source>Skin 2</source>
        <translation>Haut 2</translation>
    </message>
    <message>
        <source>Spectralon</source>
        <translation>Spectralon</translation>
    </message>
    <message>
        <source>Whole milk</source>
        <translation>Vollmilch</translation>
    </message>
</context>
<context>
    <name>scene</name>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Glossy</source>
        <translation>Glänzend</translation>
    </message>
    <message>
        <source>Treat the segment&apos;s colours as reflections</source>
        <translation>Die Farben des Segments als Spiegelungen verstehen</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How to invent the side that the camera does not see</source>
        <translation>Wie die Seite erfunden wird, die die Kamera nicht sieht</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Distance between front and back, for constant thickness</source>
        <translation>Abstand zwischen Vorder- und Rückseite bei gleichbleibender Dicke</translation>
    </message>
    <message>
        <source>Move mirror</source>
        <translation>Spiegel verschieben</translation>
    </message>
    <message>
        <source>Move the fitted mirror away from the camera</source>
        <translation>Den gefundenen Spiegel von der Kamera weg verschieben</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Strecken</translation>
    </message>
    <message>
        <source>Scale the invented thickness</source>
        <translation>Die erfundene Dicke skalieren</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>Minimum thickness anywhere on the segment</source>
        <translation>Mindestdicke überall auf dem Segment</translation>
    </message>
    <message>
        <source>Reflectance</source>
        <translation>Reflexionsgrad</translation>
    </message>
    <message>
        <source>Ratio of reflected to arriving light</source>
        <translation>Verhältnis von gespiegeltem zu ankommendem Licht</translation>
    </message>
    <message>
        <source>Lobe width</source>
        <translation>Keulenbreite</translation>
    </message>
    <message>
        <source>Blur of the segment&apos;s reflections in the photograph (GGX alpha)</source>
        <translation>Unschärfe der Spiegelungen des Segments im Foto (GGX-Alpha)</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Remove bumps and dents narrower than this: more for porcelain, less for fur and carvings. Needs the depth filter.</source>
        <translation>Buckel und Dellen glätten, die schmaler sind: mehr für Porzellan, weniger für Fell und Schnitzereien. Braucht den Tiefenfilter.</translation>
    </message>
    <message>
        <source>Filter the depth map</source>
        <translation>Tiefenkarte filtern</translation>
    </message>
    <message>
        <source>Smooth surfaces and keep outlines sharp (joint bilateral filter)</source>
        <translation>Flächen glätten, Umrisse scharf lassen (gemeinsamer bilateraler Filter)</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Adapt the filter to the measured noise of the depth map</source>
        <translation>Den Filter an das gemessene Rauschen der Tiefenkarte anpassen</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Size of the depth filter</source>
        <translation>Größe des Tiefenfilters</translation>
    </message>
    <message>
        <source>Colour range</source>
        <translation>Farbabstand</translation>
    </message>
    <message>
        <source>Separate colours that differ by more than this</source>
        <translation>Farben trennen, die sich um mehr als dies unterscheiden</translation>
    </message>
    <message>
        <source>Depth range</source>
        <translation>Tiefenabstand</translation>
    </message>
    <message>
        <source>Separate depths that differ by more than this fraction</source>
        <translation>Tiefen trennen, die sich um mehr als diesen Anteil unterscheiden</translation>
    </message>
    <message>
        <source>Fill holes to</source>
        <translation>Löcher bis</translation>
    </message>
    <message>
        <source>Fill holes up to this radius inside one segment</source>
        <translation>Löcher bis zu diesem Radius innerhalb eines Segments füllen</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Turn the light about the vertical axis of the camera</source>
        <translation>Das Licht um die senkrechte Achse der Kamera drehen</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Scale the radiance of the light</source>
        <translation>Die Strahldichte des Lichts skalieren</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Loaded map</source>
        <translation>Geladene Karte</translation>
    </message>
    <message>
        <source>Use the map as all of the light, or only where the photograph shows none</source>
        <translation>Die Karte als das ganze Licht verwenden oder nur dort, wo das Foto keines zeigt</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>How to fill directions that nothing in the photograph shows</source>
        <translation>Wie Richtungen gefüllt werden, die nichts im Foto zeigt</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastungen</translation>
    </message>
    <message>
        <source>Light paths per pixel of a finished picture</source>
        <translation>Lichtpfade je Pixel eines fertigen Bildes</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>Stop refining the view after this many seconds. Exports always use all samples.</source>
        <translation>Die Ansicht nach so vielen Sekunden nicht weiter verfeinern. Exporte haben immer alle Abtastungen.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>The same seed gives the same picture</source>
        <translation>Derselbe Startwert ergibt dasselbe Bild</translation>
    </message>
    <message>
        <source>Bounces</source>
        <translation>Reflexionen</translation>
    </message>
    <message>
        <source>Surfaces a light path may visit. With 1, folds reflect the object&apos;s original colour.</source>
        <translation>Flächen, die ein Lichtpfad besuchen darf. Bei 1 spiegeln Falten die ursprüngliche Farbe des Objekts.</translation>
    </message>
    <message>
        <source>Smooth noise, keep edges</source>
        <translation>Rauschen glätten, Kanten erhalten</translation>
    </message>
    <message>
        <source>Filter the new picture inside each segment, edge-aware</source>
        <translation>Das neue Bild innerhalb jedes Segments kantenerhaltend filtern</translation>
    </message>
    <message>
        <source>Surface samples</source>
        <translation>Oberflächenpunkte</translation>
    </message>
    <message>
        <source>Points on front and back of a translucent segment</source>
        <translation>Punkte auf Vorder- und Rückseite eines transluzenten Segments</translation>
    </message>
    <message>
        <source>Irradiance rays</source>
        <translation>Lichtpfade</translation>
    </message>
    <message>
        <source>Light paths per surface sample</source>
        <translation>Lichtpfade je Oberflächenpunkt</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Accuracy of summing the light of all surface samples</source>
        <translation>Genauigkeit, mit der das Licht aller Oberflächenpunkte summiert wird</translation>
    </message>
    <message>
        <source>Rounded: mirrored at its outline</source>
        <translation>Rund: am eigenen Umriss gespiegelt</translation>
    </message>
    <message>
        <source>Box: flat faces continued</source>
        <translation>Kasten: ebene Flächen fortgesetzt</translation>
    </message>
    <message>
        <source>Mirrored at a fitted plane</source>
        <translation>An einer angepassten Ebene gespiegelt</translation>
    </message>
    <message>
        <source>Mirrored at a plane facing the camera</source>
        <translation>An einer Ebene parallel zum Bild gespiegelt</translation>
    </message>
    <message>
        <source>Constant thickness</source>
        <translation>Gleichbleibende Dicke</translation>
    </message>
    <message>
        <source>Replaces the recovered light</source>
        <translation>Ersetzt das gewonnene Licht</translation>
    </message>
    <message>
        <source>Completes the recovered light</source>
        <translation>Ergänzt das gewonnene Licht</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Inverse distance (Shepard)</source>
        <translation>Inverser Abstand (Shepard)</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Fein</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Weight of the new surface</source>
        <translation>Gewicht der neuen Oberfläche</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Weight of the photograph underneath</source>
        <translation>Gewicht des Fotos darunter</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Better dipole: more accurate for strongly absorbing materials</source>
        <translation>Besserer Dipol: genauer bei stark absorbierenden Materialien</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>Relative index of refraction; 1 = no boundary</source>
        <translation>Relativer Brechungsindex; 1 = keine Grenzfläche</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Scale the object by this factor; larger objects look less translucent</source>
        <translation>Das Objekt um diesen Faktor skalieren; größere Objekte wirken weniger transluzent</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Scale the light that was scattered inside</source>
        <translation>Das innen gestreute Licht skalieren</translation>
    </message>
</context>
<context>
    <name>tasks</name>
    <message>
        <source>Working</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading the photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovering depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing normals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inventing back sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Building depth layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimating reflectance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovering the environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Separating texture from shading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Rendern</translation>
    </message>
    <message>
        <source>Filtering the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Summing diffuse light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running benchmarks</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui</name>
    <message>
        <source>Vulkan is not available here (error %1): the picture cannot be shown.</source>
        <translation>Vulkan ist hier nicht verfügbar (Fehler %1): Das Bild kann nicht gezeigt werden.</translation>
    </message>
</context>
<context>
    <name>ui::BackSidePanel</name>
    <message>
        <source>Preview of the back side</source>
        <translation>Vorschau der Rückseite</translation>
    </message>
    <message>
        <source>Measured back side</source>
        <translation>Gemessene Rückseite</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove measured back side</source>
        <translation>Gemessene Rückseite entfernen</translation>
    </message>
    <message>
        <source>No segment selected</source>
        <translation>Kein Segment ausgewählt</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Select a segment to see its front and back.</source>
        <translation>Wählen Sie ein Segment, um Vorder- und Rückseite zu sehen.</translation>
    </message>
    <message>
        <source>The geometry is being computed.</source>
        <translation>Die Geometrie wird berechnet.</translation>
    </message>
    <message>
        <source>Depth maps (*.exr *.png *.tif *.tiff *.pfm);;All files (*)</source>
        <translation>Tiefenkarten (*.exr *.png *.tif *.tiff *.pfm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The back side &quot;%1&quot; is %2x%3 pixels, but the photograph is %4x%5.</source>
        <translation>Die Rückseite „%1“ hat %2x%3 Pixel, das Foto aber %4x%5.</translation>
    </message>
    <message>
        <source>Load measured back side</source>
        <translation>Gemessene Rückseite laden</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Automatic: %1 (penalty %2)</source>
        <translation>Automatisch: %1 (Abweichung %2)</translation>
    </message>
    <message>
        <source>Penalty %1</source>
        <translation>Abweichung %1</translation>
    </message>
    <message>
        <source>Ends at the plane it stands on.</source>
        <translation>Endet an der Ebene, auf der es steht.</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorderseite</translation>
    </message>
    <message>
        <source>Use a depth map of the far side (metres, planar) instead of the invented one</source>
        <translation>Eine Tiefenkarte der Rückseite (Meter, entlang der Blickachse) statt der erfundenen verwenden</translation>
    </message>
    <message>
        <source>Return to the invented back side</source>
        <translation>Zurück zur erfundenen Rückseite</translation>
    </message>
</context>
<context>
    <name>ui::BackgroundTask</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
</context>
<context>
    <name>ui::Canvas</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The graphics device is lost whenever this picture is drawn. Your edits are not affected: undo the last one, or save and start Patina again with another device.</source>
        <translation>Das Grafikgerät fällt bei diesem Bild jedes Mal aus. Ihre Bearbeitung ist nicht betroffen: Machen Sie den letzten Schritt rückgängig, oder speichern Sie und starten Sie Patina mit einem anderen Gerät neu.</translation>
    </message>
</context>
<context>
    <name>ui::CanvasWindow</name>
    <message>
        <source>The graphics device was lost and is being started again. Your edits are not affected.</source>
        <translation>Das Grafikgerät ist ausgefallen und wird neu gestartet. Ihre Bearbeitung ist nicht betroffen.</translation>
    </message>
    <message>
        <source>The graphics device is gone. Your edits are not affected: save, and start Patina again.</source>
        <translation>Das Grafikgerät ist nicht mehr da. Ihre Bearbeitung ist nicht betroffen: Speichern Sie und starten Sie Patina neu.</translation>
    </message>
</context>
<context>
    <name>ui::ColorButton</name>
    <message>
        <source>%1: linear %2, %3, %4. Click to change.</source>
        <translation>%1: linear %2, %3, %4. Zum Ändern klicken.</translation>
    </message>
</context>
<context>
    <name>ui::DriveList</name>
    <message>
        <source>Vary a parameter</source>
        <translation>Einen Parameter veränderlich machen</translation>
    </message>
    <message>
        <source>Let a parameter follow a painted mask, an image or the photograph&apos;s texture</source>
        <translation>Einen Parameter einer gemalten Maske, einem Bild oder der Textur des Fotos folgen lassen</translation>
    </message>
    <message>
        <source>Brush size</source>
        <translation>Pinselgröße</translation>
    </message>
    <message>
        <source>Radius in pixels of the photograph</source>
        <translation>Radius in Pixeln des Fotos</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Vary %1</source>
        <translation>%1 veränderlich machen</translation>
    </message>
    <message>
        <source>Follow the photograph&apos;s texture</source>
        <translation>Der Textur des Fotos folgen</translation>
    </message>
    <message>
        <source>Change mask</source>
        <translation>Maske ändern</translation>
    </message>
    <message>
        <source>Load mask</source>
        <translation>Maske laden</translation>
    </message>
    <message>
        <source>Images (*.png *.tif *.jpg *.exr);;All files (*)</source>
        <translation>Bilder (*.png *.tif *.jpg *.exr);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>%1 wird geladen</translation>
    </message>
    <message>
        <source>The mask &quot;%1&quot; is %2x%3 pixels, expected the photograph&apos;s size %4x%5.</source>
        <translation>Die Maske „%1“ hat %2x%3 Pixel, erwartet wird die Größe des Fotos %4x%5.</translation>
    </message>
    <message>
        <source>Change start value</source>
        <translation>Anfangswert ändern</translation>
    </message>
    <message>
        <source>Change end value</source>
        <translation>Endwert ändern</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Where the mask is black</source>
        <translation>Wo die Maske schwarz ist</translation>
    </message>
    <message>
        <source>Where the mask is white</source>
        <translation>Wo die Maske weiß ist</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Source of %1</source>
        <translation>Quelle von %1</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>%1 malen</translation>
    </message>
    <message>
        <source>Paint the mask in the picture</source>
        <translation>Die Maske im Bild malen</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Contrast of the mask, or strength of the texture</source>
        <translation>Kontrast der Maske oder Stärke der Textur</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Do not vary %1</source>
        <translation>%1 nicht mehr verändern</translation>
    </message>
    <message>
        <source>Change contrast</source>
        <translation>Kontrast ändern</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Vary a parameter…</source>
        <translation>Parameter veränderlich machen…</translation>
    </message>
    <message>
        <source>Painted mask</source>
        <translation>Gemalte Maske</translation>
    </message>
    <message>
        <source>Image %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>Image…</source>
        <translation>Bild…</translation>
    </message>
    <message>
        <source>Photograph&apos;s texture</source>
        <translation>Textur des Fotos</translation>
    </message>
    <message>
        <source>Mask of %1</source>
        <translation>Maske von %1</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>Fraction of the radius at full strength</source>
        <translation>Anteil des Radius mit voller Stärke</translation>
    </message>
    <message>
        <source>Opacity of one stroke</source>
        <translation>Deckkraft eines Strichs</translation>
    </message>
    <message>
        <source>Paint the start value; hold Shift to do so for one stroke</source>
        <translation>Den Anfangswert malen; Umschalttaste halten: nur für einen Strich</translation>
    </message>
    <message>
        <source>Use one value for the whole segment</source>
        <translation>Einen Wert für das ganze Segment verwenden</translation>
    </message>
    <message>
        <source>Choose what the parameter follows</source>
        <translation>Wählen, wem der Parameter folgt</translation>
    </message>
</context>
<context>
    <name>ui::EnvironmentPanel</name>
    <message>
        <source>Lobe width %1, estimated</source>
        <translation>Keulenbreite %1, geschätzt</translation>
    </message>
    <message>
        <source>Light around the scene</source>
        <translation>Licht um die Szene</translation>
    </message>
    <message>
        <source>Reflected by the segment (L_S)</source>
        <translation>Vom Segment gespiegelt (L_S)</translation>
    </message>
    <message>
        <source>Arriving at the segment (L_G)</source>
        <translation>Am Segment ankommend (L_G)</translation>
    </message>
    <message>
        <source>Directional map</source>
        <translation>Richtungskarte</translation>
    </message>
    <message>
        <source>View exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>EV</source>
        <translation>LW</translation>
    </message>
    <message>
        <source>Brightness of this view only</source>
        <translation>Helligkeit nur dieser Ansicht</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Load HDRI…</source>
        <translation>HDRI laden…</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiedergewinnen</translation>
    </message>
    <message>
        <source>Reflectance of the segment</source>
        <translation>Reflexionsgrad des Segments</translation>
    </message>
    <message>
        <source>Load environment</source>
        <translation>Umgebung laden</translation>
    </message>
    <message>
        <source>Environment maps (*.exr *.hdr *.png *.jpg *.tif);;All files (*)</source>
        <translation>Umgebungskarten (*.exr *.hdr *.png *.jpg *.tif);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Recover light</source>
        <translation>Licht wiedergewinnen</translation>
    </message>
    <message>
        <source>The environment map &quot;%1&quot; is %2x%3 pixels; a latitude-longitude map is twice as wide as high.</source>
        <translation>Die Umgebungskarte „%1“ hat %2x%3 Pixel; eine Längen-Breiten-Karte ist doppelt so breit wie hoch.</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>%1 wird geladen</translation>
    </message>
    <message>
        <source>Recovered from the photograph</source>
        <translation>Aus dem Foto gewonnen</translation>
    </message>
    <message>
        <source>Select a segment flagged as glossy.</source>
        <translation>Wählen Sie ein als glänzend markiertes Segment.</translation>
    </message>
    <message>
        <source>Being estimated.</source>
        <translation>Wird geschätzt.</translation>
    </message>
    <message>
        <source>ρ = %1, %2, %3</source>
        <translation>ρ = %1, %2, %3</translation>
    </message>
    <message>
        <source>, from %1 sr known both ways</source>
        <translation>, aus %1 sr, die beidseitig bekannt sind</translation>
    </message>
    <message>
        <source>The light is being recovered.</source>
        <translation>Das Licht wird wiedergewonnen.</translation>
    </message>
    <message>
        <source>There is no light to show.</source>
        <translation>Es gibt kein Licht zu zeigen.</translation>
    </message>
    <message>
        <source>Displayed map</source>
        <translation>Gezeigte Karte</translation>
    </message>
    <message>
        <source>Show the light around the scene, or the maps of the selected glossy segment</source>
        <translation>Das Licht um die Szene oder die Karten des gewählten glänzenden Segments zeigen</translation>
    </message>
    <message>
        <source>Highlight estimated directions</source>
        <translation>Geschätzte Richtungen hervorheben</translation>
    </message>
    <message>
        <source>Hatch the interpolated directions, which nothing in the photograph reflects</source>
        <translation>Die interpolierten Richtungen schraffieren, die nichts im Foto spiegelt</translation>
    </message>
    <message>
        <source>Light the edits with a latitude-longitude map (EXR or HDR) instead of the recovered light</source>
        <translation>Mit einer Längen-Breiten-Karte (EXR oder HDR) statt mit dem wiedergewonnenen Licht beleuchten</translation>
    </message>
    <message>
        <source>Return to the light recovered from the photograph</source>
        <translation>Zurück zum aus dem Foto gewonnenen Licht</translation>
    </message>
    <message>
        <source> (custom)</source>
        <translation> (eigener Wert)</translation>
    </message>
    <message>
        <source>. Only %1 sr are known both ways: a guess, better set it yourself.</source>
        <translation>. Nur %1 sr sind beidseitig bekannt: geschätzt, besser selbst setzen.</translation>
    </message>
    <message>
        <source>Lobe width %1, assumed: the reflections show no detail</source>
        <translation>Keulenbreite %1, angenommen: die Spiegelungen zeigen keine Einzelheiten</translation>
    </message>
    <message>
        <source>No project open</source>
        <translation>Kein Projekt geöffnet</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>No canvas was asked for.</source>
        <translation>Keine Zeichenfläche verlangt.</translation>
    </message>
    <message>
        <source>Analysing: %1, %2 %</source>
        <translation>Analyse: %1, %2 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>What is under the pointer</source>
        <translation>Was unter dem Zeiger liegt</translation>
    </message>
    <message>
        <source>What is being computed</source>
        <translation>Was gerade berechnet wird</translation>
    </message>
    <message>
        <source>Zoom: picture pixels to screen pixels</source>
        <translation>Zoom: Bildpixel zu Bildschirmpixeln</translation>
    </message>
    <message>
        <source>Device in use</source>
        <translation>Verwendetes Gerät</translation>
    </message>
    <message>
        <source>Progress of the picture</source>
        <translation>Fortschritt des Bildes</translation>
    </message>
    <message>
        <source>Analysing</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>%1[*] - Patina</source>
        <translation>%1[*] - Patina</translation>
    </message>
    <message>
        <source>Patina</source>
        <translation>Patina</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Finished, %1 samples</source>
        <translation>Fertig, %1 Abtastungen</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>%1 of %2 samples</source>
        <translation>%1 von %2 Abtastungen</translation>
    </message>
    <message>
        <source>(%1, %2)   %3</source>
        <translation>(%1, %2)   %3</translation>
    </message>
    <message>
        <source>  →  %1</source>
        <translation>  →  %1</translation>
    </message>
    <message>
        <source>   %1 m</source>
        <translation>   %1 m</translation>
    </message>
    <message>
        <source>   no depth</source>
        <translation>   keine Tiefe</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Kein Gerät</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Compute on (from the next start):</source>
        <translation>Rechnen auf (ab dem nächsten Start):</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New from photo and depth…</source>
        <translation>&amp;Neu aus Foto und Tiefe…</translation>
    </message>
    <message>
        <source>Start a project from a photograph and its depth map</source>
        <translation>Ein Projekt mit einem Foto und seiner Tiefenkarte beginnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Ein Projekt öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Das Projekt speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Das Projekt unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>&amp;Export picture…</source>
        <translation>Bild &amp;exportieren…</translation>
    </message>
    <message>
        <source>Render the edited photograph to the end and save it</source>
        <translation>Das bearbeitete Foto zu Ende rechnen und speichern</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>PNG, 16 bit (*.png);;OpenEXR, linear (*.exr);;TIFF, 16 bit (*.tif);;JPEG (*.jpg);;Radiance HDR, linear (*.hdr)</source>
        <translation>PNG, 16 Bit (*.png);;OpenEXR, linear (*.exr);;TIFF, 16 Bit (*.tif);;JPEG (*.jpg);;Radiance HDR, linear (*.hdr)</translation>
    </message>
    <message>
        <source>Export se&amp;gmentation…</source>
        <translation>Se&amp;gmentierung exportieren…</translation>
    </message>
    <message>
        <source>Save the label map</source>
        <translation>Die Segmentkarte speichern</translation>
    </message>
    <message>
        <source>Export segmentation</source>
        <translation>Segmentierung exportieren</translation>
    </message>
    <message>
        <source>PNG (*.png);;TIFF (*.tif);;OpenEXR (*.exr)</source>
        <translation>PNG (*.png);;TIFF (*.tif);;OpenEXR (*.exr)</translation>
    </message>
    <message>
        <source>Export en&amp;vironment…</source>
        <translation>U&amp;mgebung exportieren…</translation>
    </message>
    <message>
        <source>Save the light around the scene as a latitude-longitude map</source>
        <translation>Das Licht um die Szene als Längen-Breiten-Karte speichern</translation>
    </message>
    <message>
        <source>Export environment</source>
        <translation>Umgebung exportieren</translation>
    </message>
    <message>
        <source>OpenEXR, linear (*.exr);;Radiance HDR, linear (*.hdr);;PNG (*.png)</source>
        <translation>OpenEXR, linear (*.exr);;Radiance HDR, linear (*.hdr);;PNG (*.png)</translation>
    </message>
    <message>
        <source>&amp;Device…</source>
        <translation>&amp;Gerät…</translation>
    </message>
    <message>
        <source>Choose the graphics device</source>
        <translation>Das Grafikgerät wählen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Leave Patina</source>
        <translation>Patina verlassen</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>Take back the last step</source>
        <translation>Den letzten Schritt zurücknehmen</translation>
    </message>
    <message>
        <source>Repeat the step that was taken back</source>
        <translation>Den zurückgenommenen Schritt wiederholen</translation>
    </message>
    <message>
        <source>&amp;Deselect</source>
        <translation>Auswahl auf&amp;heben</translation>
    </message>
    <message>
        <source>Select no segment</source>
        <translation>Kein Segment auswählen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Show: %1</source>
        <translation>Zeigen: %1</translation>
    </message>
    <message>
        <source>&amp;Fit in window</source>
        <translation>In Fenster ein&amp;passen</translation>
    </message>
    <message>
        <source>Show the whole picture</source>
        <translation>Das ganze Bild zeigen</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100 %</translation>
    </message>
    <message>
        <source>One picture pixel on one screen pixel</source>
        <translation>Ein Bildpixel auf einem Bildschirmpixel</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>&amp;Brighter</source>
        <translation>&amp;Heller</translation>
    </message>
    <message>
        <source>View a third of a stop brighter; the picture itself is not changed</source>
        <translation>Ansicht eine Drittelblende heller; das Bild selbst bleibt gleich</translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation>&amp;Dunkler</translation>
    </message>
    <message>
        <source>View a third of a stop darker; the picture itself is not changed</source>
        <translation>Ansicht eine Drittelblende dunkler; das Bild selbst bleibt gleich</translation>
    </message>
    <message>
        <source>&amp;Normal exposure</source>
        <translation>&amp;Normale Belichtung</translation>
    </message>
    <message>
        <source>View as exposed</source>
        <translation>Ansicht wie belichtet</translation>
    </message>
    <message>
        <source>Selection ou&amp;tline</source>
        <translation>Umriss der Aus&amp;wahl</translation>
    </message>
    <message>
        <source>Outline the selected segment</source>
        <translation>Das gewählte Segment umranden</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Bereiche</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>How to use Patina</source>
        <translation>Wie man Patina benutzt</translation>
    </message>
    <message>
        <source>&amp;About Patina</source>
        <translation>Ü&amp;ber Patina</translation>
    </message>
    <message>
        <source>Version and device</source>
        <translation>Version und Gerät</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source> Show </source>
        <translation> Zeigen </translation>
    </message>
    <message>
        <source>What to show</source>
        <translation>Was gezeigt wird</translation>
    </message>
    <message>
        <source>What the canvas shows. Hold C, or the right mouse button, to see the original.</source>
        <translation>Was gezeigt wird. C oder die rechte Maustaste gedrückt halten, um das Original zu sehen.</translation>
    </message>
    <message>
        <source>  Exposure </source>
        <translation>  Belichtung </translation>
    </message>
    <message>
        <source>Exposure of the view</source>
        <translation>Belichtung der Ansicht</translation>
    </message>
    <message>
        <source>Brightness of the view in stops; the picture itself is not changed</source>
        <translation>Helligkeit der Ansicht in Blendenstufen; das Bild selbst bleibt gleich</translation>
    </message>
    <message>
        <source> EV</source>
        <translation> LW</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>About Patina</source>
        <translation>Über Patina</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Patina %1&lt;/h3&gt;&lt;p&gt;Changes what things in a photograph are made of.&lt;/p&gt;&lt;p&gt;After S. Bergmann, T. Ritschel, C. Dachsbacher, &lt;i&gt;Interactive Appearance Editing in RGB-D Images&lt;/i&gt;, VMV 2014.&lt;/p&gt;&lt;p&gt;Device: %2&lt;br&gt;Qt %3&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Patina %1&lt;/h3&gt;&lt;p&gt;Ändert, woraus Dinge in einem Foto bestehen.&lt;/p&gt;&lt;p&gt;Nach S. Bergmann, T. Ritschel, C. Dachsbacher, &lt;i&gt;Interactive Appearance Editing in RGB-D Images&lt;/i&gt;, VMV 2014.&lt;/p&gt;&lt;p&gt;Gerät: %2&lt;br&gt;Qt %3&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder neuer.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Please wait until the running work is done.</source>
        <translation>Bitte warten Sie, bis die laufende Arbeit fertig ist.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>The project has changes that are not saved. Save them first?</source>
        <translation>Das Projekt hat ungespeicherte Änderungen. Zuerst speichern?</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Projects and photographs (*.patina *.exr *.jpg *.jpeg *.heic *.heif *.pcd);;Patina projects (*.patina);;All files (*)</source>
        <translation>Projekte und Fotos (*.patina *.exr *.jpg *.jpeg *.heic *.heif *.pcd);;Patina-Projekte (*.patina);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Patina projects (*.patina)</source>
        <translation>Patina-Projekte (*.patina)</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 exportiert</translation>
    </message>
    <message>
        <source>&amp;Ruler</source>
        <translation>Maß&amp;stab</translation>
    </message>
    <message>
        <source>Show how large the selected translucent object is, in its substance</source>
        <translation>Zeigen, wie groß das gewählte durchscheinende Objekt für seinen Stoff ist</translation>
    </message>
    <message>
        <source>Time limit, %1 of %2 samples</source>
        <translation>Zeitgrenze, %1 von %2 Abtastungen</translation>
    </message>
    <message>
        <source>Paused, %1 of %2 samples</source>
        <translation>Angehalten, %1 von %2 Abtastungen</translation>
    </message>
    <message>
        <source>&amp;Pause refinement</source>
        <translation>Verfeinerung &amp;anhalten</translation>
    </message>
    <message>
        <source>Show changes, but leave the device idle instead of refining them</source>
        <translation>Änderungen zeigen, das Gerät aber ruhen lassen, statt sie zu verfeinern</translation>
    </message>
</context>
<context>
    <name>ui::MapView</name>
    <message>
        <source>clipped by the camera, estimated</source>
        <translation>von der Kamera abgeschnitten, geschätzt</translation>
    </message>
    <message>
        <source>azimuth %1°, elevation %2°: %3, %4, %5; %6</source>
        <translation>Azimut %1°, Höhe %2°: %3, %4, %5; %6</translation>
    </message>
    <message>
        <source>observed</source>
        <translation>beobachtet</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>interpoliert</translation>
    </message>
</context>
<context>
    <name>ui::MaskPainter</name>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
</context>
<context>
    <name>ui::MaterialPanel</name>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei…</translation>
    </message>
    <message>
        <source>Material from a file</source>
        <translation>Material aus einer Datei</translation>
    </message>
    <message>
        <source>BRDFs: GLSL, or measured in MERL&apos;s format (*.brdf.glsl *.binary);;All files (*)</source>
        <translation>BRDFs: GLSL oder im MERL-Format gemessen (*.brdf.glsl *.binary);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reload %1</source>
        <translation>%1 neu laden</translation>
    </message>
    <message>
        <source>Shown as photographed: %1</source>
        <translation>Wie fotografiert gezeigt: %1</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>%1 wird geladen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>How the new surface reflects light</source>
        <translation>Wie die neue Oberfläche Licht zurückwirft</translation>
    </message>
    <message>
        <source>As photographed</source>
        <translation>Wie fotografiert</translation>
    </message>
    <message>
        <source>Remove edit</source>
        <translation>Änderung entfernen</translation>
    </message>
    <message>
        <source>Show the segment as it was photographed</source>
        <translation>Das Segment zeigen, wie es fotografiert wurde</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Diffuse colour</source>
        <translation>Diffuse Farbe</translation>
    </message>
    <message>
        <source>Specular colour</source>
        <translation>Spiegelfarbe</translation>
    </message>
    <message>
        <source>Estimated</source>
        <translation>Geschätzt</translation>
    </message>
    <message>
        <source>Use the reflectance estimated from the photograph (glossy segments)</source>
        <translation>Den aus dem Foto geschätzten Reflexionsgrad verwenden (glänzende Segmente)</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Diffus</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Spiegelnd</translation>
    </message>
    <message>
        <source>Fresnel</source>
        <translation>Fresnel</translation>
    </message>
    <message>
        <source>Same at every angle</source>
        <translation>Bei jedem Winkel gleich</translation>
    </message>
    <message>
        <source>Schlick</source>
        <translation>Schlick</translation>
    </message>
    <message>
        <source>Dielectric</source>
        <translation>Dielektrikum</translation>
    </message>
    <message>
        <source>Conductor</source>
        <translation>Leiter</translation>
    </message>
    <message>
        <source>Index n</source>
        <translation>Index n</translation>
    </message>
    <message>
        <source>Index of refraction</source>
        <translation>Brechungsindex</translation>
    </message>
    <message>
        <source>Extinction k</source>
        <translation>Extinktion k</translation>
    </message>
    <message>
        <source>Extinction coefficient of a metal</source>
        <translation>Extinktionskoeffizient eines Metalls</translation>
    </message>
    <message>
        <source>Change diffuse colour</source>
        <translation>Diffuse Farbe ändern</translation>
    </message>
    <message>
        <source>Change specular colour</source>
        <translation>Spiegelfarbe ändern</translation>
    </message>
    <message>
        <source>Estimate specular colour</source>
        <translation>Spiegelfarbe schätzen</translation>
    </message>
    <message>
        <source>Choose specular colour</source>
        <translation>Spiegelfarbe wählen</translation>
    </message>
    <message>
        <source>Change Fresnel</source>
        <translation>Fresnel ändern</translation>
    </message>
    <message>
        <source>Change index of refraction</source>
        <translation>Brechungsindex ändern</translation>
    </message>
    <message>
        <source>Change extinction</source>
        <translation>Extinktion ändern</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>Translucency</source>
        <translation>Transluzenz</translation>
    </message>
    <message>
        <source>Light that enters the object, scatters and leaves elsewhere: wax, marble, skin</source>
        <translation>Licht, das eindringt, gestreut wird und anderswo austritt: Wachs, Marmor, Haut</translation>
    </message>
    <message>
        <source>Substance</source>
        <translation>Stoff</translation>
    </message>
    <message>
        <source>Measured substances</source>
        <translation>Gemessene Stoffe</translation>
    </message>
    <message>
        <source>Absorption</source>
        <translation>Absorption</translation>
    </message>
    <message>
        <source>Absorption coefficient [1/mm]</source>
        <translation>Absorptionskoeffizient [1/mm]</translation>
    </message>
    <message>
        <source>Scattering</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Reduced scattering coefficient [1/mm]</source>
        <translation>Reduzierter Streukoeffizient [1/mm]</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>1/mm</source>
        <translation>1/mm</translation>
    </message>
    <message>
        <source>Make translucent</source>
        <translation>Transluzent machen</translation>
    </message>
    <message>
        <source>Make opaque</source>
        <translation>Undurchsichtig machen</translation>
    </message>
    <message>
        <source>Choose substance</source>
        <translation>Stoff wählen</translation>
    </message>
    <message>
        <source>Change absorption</source>
        <translation>Absorption ändern</translation>
    </message>
    <message>
        <source>Change scattering</source>
        <translation>Streuung ändern</translation>
    </message>
    <message>
        <source>Change material to %1</source>
        <translation>Material zu %1 ändern</translation>
    </message>
    <message>
        <source>Click a segment in the picture or in the list</source>
        <translation>Klicken Sie ein Segment im Bild oder in der Liste an</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>Measured n and k of pure metals</source>
        <translation>Gemessene n und k reiner Metalle</translation>
    </message>
    <message>
        <source>Choose metal</source>
        <translation>Metall wählen</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Free path</source>
        <translation>Freie Weglänge</translation>
    </message>
    <message>
        <source>Colour of a thick piece; changes absorption and scattering</source>
        <translation>Farbe eines dicken Stücks; ändert Absorption und Streuung</translation>
    </message>
    <message>
        <source>Change diffusion colour</source>
        <translation>Streufarbe ändern</translation>
    </message>
    <message>
        <source>Change free path</source>
        <translation>Freie Weglänge ändern</translation>
    </message>
    <message>
        <source>How reflection increases towards grazing angles</source>
        <translation>Wie die Spiegelung zu streifenden Winkeln hin zunimmt</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene Werte</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Depth that light reaches [mm]; changes absorption and scattering</source>
        <translation>Tiefe, die Licht erreicht [mm]; ändert Absorption und Streuung</translation>
    </message>
    <message>
        <source>Showing the last valid version: %1</source>
        <translation>Gezeigt wird die letzte gültige Fassung: %1</translation>
    </message>
    <message>
        <source>No project open</source>
        <translation>Kein Projekt geöffnet</translation>
    </message>
</context>
<context>
    <name>ui::NewPhotoDialog</name>
    <message>
        <source>New from photograph and depth</source>
        <translation>Neu aus Foto und Tiefe</translation>
    </message>
    <message>
        <source>Pictures (*.exr *.png *.jpg *.jpeg *.tif *.tiff *.hdr *.pfm);;All files (*)</source>
        <translation>Bilder (*.exr *.png *.jpg *.jpeg *.tif *.tiff *.hdr *.pfm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>The colour picture; EXR and HDR are taken as linear light</source>
        <translation>Das Farbbild; EXR und HDR gelten als lineares Licht</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>A depth map of the same view; leave it empty when the photograph carries its depth (phones&apos; portrait photos, EXR with a channel Z, point clouds)</source>
        <translation>Eine Tiefenkarte derselben Ansicht; leer lassen, wenn das Foto seine Tiefe selbst enthält (Porträtfotos von Telefonen, EXR mit einem Kanal Z, Punktwolken)</translation>
    </message>
    <message>
        <source>What the numbers in the depth file mean</source>
        <translation>Was die Zahlen in der Tiefendatei bedeuten</translation>
    </message>
    <message>
        <source>Depth along the viewing axis</source>
        <translation>Tiefe entlang der Blickachse</translation>
    </message>
    <message>
        <source>Distance from the camera</source>
        <translation>Abstand von der Kamera</translation>
    </message>
    <message>
        <source>Disparity (phones)</source>
        <translation>Disparität (Telefone)</translation>
    </message>
    <message>
        <source>Inverse depth (networks)</source>
        <translation>Inverse Tiefe (Netze)</translation>
    </message>
    <message>
        <source>Depth is</source>
        <translation>Tiefe ist</translation>
    </message>
    <message>
        <source>Metres per stored unit; automatic is what the photograph says, else 1 for floating point files, 0.001 for 16-bit ones</source>
        <translation>Meter je gespeicherter Einheit; automatisch gilt, was das Foto angibt, sonst 1 bei Gleitkommadateien, 0,001 bei 16 Bit</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Depth unit</source>
        <translation>Tiefeneinheit</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>A label map: one number per object, 0 for none</source>
        <translation>Eine Segmentkarte: eine Zahl je Objekt, 0 für keines</translation>
    </message>
    <message>
        <source>Horizontal field of view; automatic reads it from the photograph, else takes 60°</source>
        <translation>Waagrechter Bildwinkel; automatisch liest ihn aus dem Foto, sonst 60°</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Photographs (*.exr *.png *.jpg *.jpeg *.heic *.heif *.tif *.tiff *.hdr *.pfm *.pcd);;All files (*)</source>
        <translation>Fotos (*.exr *.png *.jpg *.jpeg *.heic *.heif *.tif *.tiff *.hdr *.pfm *.pcd);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>ui::Panel</name>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
</context>
<context>
    <name>ui::ParamControl</name>
    <message>
        <source>%1: automatic</source>
        <translation>%1: automatisch</translation>
    </message>
    <message>
        <source>Use the estimate from the photograph</source>
        <translation>Die Schätzung aus dem Foto verwenden</translation>
    </message>
</context>
<context>
    <name>ui::ParamSlider</name>
    <message>
        <source>%1
Double-click the label to reset to %2.</source>
        <translation>%1
Doppelklick auf die Beschriftung setzt auf %2 zurück.</translation>
    </message>
</context>
<context>
    <name>ui::ProfileView</name>
    <message>
        <source>This segment has no valid depth.</source>
        <translation>Dieses Segment hat keine gültige Tiefe.</translation>
    </message>
    <message>
        <source>thickness, up to %1 mm</source>
        <translation>Dicke, bis %1 mm</translation>
    </message>
    <message>
        <source>cut: front | back</source>
        <translation>Schnitt: vorn | hinten</translation>
    </message>
</context>
<context>
    <name>ui::RenderPanel</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Translucency</source>
        <translation>Transluzenz</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
</context>
<context>
    <name>ui::SegmentsPanel</name>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>Glossy</source>
        <translation>Glänzend</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>Bearbeitet</translation>
    </message>
    <message>
        <source>No segments: open a project, or a photograph with a label map.</source>
        <translation>Keine Segmente: Öffnen Sie ein Projekt oder ein Foto mit Segmentkarte.</translation>
    </message>
    <message>
        <source>Segment %1, label %2</source>
        <translation>Segment %1, Nummer %2</translation>
    </message>
    <message>
        <source>Has a new material</source>
        <translation>Hat ein neues Material</translation>
    </message>
    <message>
        <source>Unchanged</source>
        <translation>Unverändert</translation>
    </message>
    <message>
        <source>Flag %1 as glossy</source>
        <translation>%1 als glänzend markieren</translation>
    </message>
    <message>
        <source>Flag %1 as not glossy</source>
        <translation>%1 als nicht glänzend markieren</translation>
    </message>
    <message>
        <source>A segment needs a name.</source>
        <translation>Ein Segment braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is already a segment named &quot;%1&quot;.</source>
        <translation>Es gibt schon ein Segment namens „%1“.</translation>
    </message>
    <message>
        <source>Rename segment</source>
        <translation>Segment umbenennen</translation>
    </message>
    <message>
        <source>Glossy segments show reflections, from which the light is recovered.</source>
        <translation>Glänzende Segmente zeigen Spiegelungen, aus denen das Licht gewonnen wird.</translation>
    </message>
    <message>
        <source>Click to select a segment, double-click to rename it, check the box to flag it as glossy.</source>
        <translation>Klicken wählt ein Segment, Doppelklicken benennt es um, das Kästchen markiert es als glänzend.</translation>
    </message>
    <message>
        <source>Treat the segment&apos;s colours as reflections</source>
        <translation>Die Farben des Segments als Spiegelungen verstehen</translation>
    </message>
</context>
<context>
    <name>ui::VectorEdit</name>
    <message>
        <source>red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>Blau</translation>
    </message>
</context>
</TS>
