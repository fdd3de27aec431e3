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
    <name>ui</name>
    <message>
        <source>Vulkan is not available here (error %1): the picture cannot be shown.</source>
        <translation>Vulkan ist hier nicht verfügbar (Fehler %1): Das Bild kann nicht gezeigt werden.</translation>
    </message>
</context>
<context>
    <name>ui::BackSidePanel</name>
    <message>
        <source>Back side method</source>
        <translation>Verfahren für die Rückseite</translation>
    </message>
    <message>
        <source>How the side the camera does not see is invented</source>
        <translation>Wie die Seite erfunden wird, die die Kamera nicht sieht</translation>
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
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Distance between front and back, for constant thickness</source>
        <translation>Abstand zwischen Vorder- und Rückseite bei gleichbleibender Dicke</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>Smallest thickness anywhere on the segment</source>
        <translation>Kleinste Dicke überall auf dem Segment</translation>
    </message>
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
        <source>Use a depth map of the far side (metres, planar) in place of the invented one</source>
        <translation>Eine Tiefenkarte der Rückseite (Meter, entlang der Blickachse) statt der erfundenen verwenden</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Go back to the invented back side</source>
        <translation>Zurück zur erfundenen Rückseite</translation>
    </message>
    <message>
        <source>Change back side</source>
        <translation>Rückseite ändern</translation>
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
        <source>Automatic</source>
        <translation>Automatisch</translation>
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
        <source>Move mirror</source>
        <translation>Spiegel verschieben</translation>
    </message>
    <message>
        <source>Moves the mirror that was found away from the camera</source>
        <translation>Verschiebt den gefundenen Spiegel von der Kamera weg</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Strecken</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Factor on the thickness that was invented</source>
        <translation>Faktor auf die erfundene Dicke</translation>
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
        <source>Smooth surface automatically</source>
        <translation>Oberfläche automatisch glätten</translation>
    </message>
    <message>
        <source>The smoothing follows the noise of the depth map; part of the depth filter, which has to be on</source>
        <translation>Die Glättung richtet sich nach dem Rauschen der Tiefenkarte; sie gehört zum Tiefenfilter, der eingeschaltet sein muss</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>Bumps and dents of the surface narrower than about this are smoothed away: more for porcelain, less for fur and carving; 0 = none</source>
        <translation>Buckel und Dellen der Oberfläche, die schmaler als etwa so viel sind, werden geglättet: mehr für Porzellan, weniger für Fell und Schnitzereien; 0 = nichts</translation>
    </message>
    <message>
        <source>Set smoothing</source>
        <translation>Glättung einstellen</translation>
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
        <source>Varies</source>
        <translation>Veränderlich</translation>
    </message>
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
        <source> px</source>
        <translation> px</translation>
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
        <source>Share of the radius inside which the brush is full</source>
        <translation>Anteil des Radius, innerhalb dessen der Pinsel voll deckt</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>How far one stroke goes</source>
        <translation>Wie weit ein Strich geht</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Paint back to the start value; Shift does it for one stroke</source>
        <translation>Zum Anfangswert zurück malen; mit der Umschalttaste für einen Strich</translation>
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
        <source>The parameter is the same everywhere again</source>
        <translation>Der Parameter ist wieder überall gleich</translation>
    </message>
    <message>
        <source>Source of %1</source>
        <translation>Quelle von %1</translation>
    </message>
    <message>
        <source>What the parameter follows</source>
        <translation>Wem der Parameter folgt</translation>
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
</context>
<context>
    <name>ui::EnvironmentPanel</name>
    <message>
        <source>What the loaded map does</source>
        <translation>Was die geladene Karte tut</translation>
    </message>
    <message>
        <source>A loaded map is all of the light, or only what the photograph does not show of it</source>
        <translation>Eine geladene Karte ist das ganze Licht oder nur das, was das Foto davon nicht zeigt</translation>
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
        <source>Unseen directions</source>
        <translation>Ungesehene Richtungen</translation>
    </message>
    <message>
        <source>How directions that nothing in the photograph shows are filled</source>
        <translation>Wie Richtungen gefüllt werden, die nichts im Foto zeigt</translation>
    </message>
    <message>
        <source>Gaps: smooth</source>
        <translation>Lücken: glatt</translation>
    </message>
    <message>
        <source>Gaps: inverse distance (Shepard)</source>
        <translation>Lücken: inverser Abstand (Shepard)</translation>
    </message>
    <message>
        <source>Lobe width by hand</source>
        <translation>Keulenbreite von Hand</translation>
    </message>
    <message>
        <source>Replace the estimated width of the segment&apos;s reflections (GGX alpha)</source>
        <translation>Die geschätzte Breite der Spiegelungen des Segments ersetzen (GGX-Alpha)</translation>
    </message>
    <message>
        <source>Lobe width</source>
        <translation>Keulenbreite</translation>
    </message>
    <message>
        <source>How blurred the segment&apos;s reflections are in the photograph (GGX alpha)</source>
        <translation>Wie unscharf die Spiegelungen des Segments im Foto sind (GGX-Alpha)</translation>
    </message>
    <message>
        <source>Change use of the map</source>
        <translation>Verwendung der Karte ändern</translation>
    </message>
    <message>
        <source>Change filling of gaps</source>
        <translation>Füllen der Lücken ändern</translation>
    </message>
    <message>
        <source>Set lobe width</source>
        <translation>Keulenbreite setzen</translation>
    </message>
    <message>
        <source>Estimate lobe width</source>
        <translation>Keulenbreite schätzen</translation>
    </message>
    <message>
        <source>Lobe width %1, estimated</source>
        <translation>Keulenbreite %1, geschätzt</translation>
    </message>
    <message>
        <source>Lobe width %1, assumed: nothing with detail is reflected</source>
        <translation>Keulenbreite %1, angenommen: es spiegelt sich nichts mit Einzelheiten</translation>
    </message>
    <message>
        <source>Map shown</source>
        <translation>Gezeigte Karte</translation>
    </message>
    <message>
        <source>The light around the scene, or what is known about the selected glossy segment</source>
        <translation>Das Licht um die Szene oder was über das gewählte glänzende Segment bekannt ist</translation>
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
        <source>Mark what is guessed</source>
        <translation>Geschätztes kennzeichnen</translation>
    </message>
    <message>
        <source>Hatch the directions nothing in the photograph reflects; they are interpolated</source>
        <translation>Richtungen schraffieren, die nichts im Foto spiegelt; sie sind interpoliert</translation>
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
        <source>Light the edits with a latitude-longitude map (EXR or HDR) in place of the recovered one</source>
        <translation>Mit einer Längen-Breiten-Karte (EXR oder HDR) statt mit dem wiedergewonnenen Licht beleuchten</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiedergewinnen</translation>
    </message>
    <message>
        <source>Go back to the light recovered from the photograph</source>
        <translation>Zurück zum aus dem Foto gewonnenen Licht</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turns the light about the vertical axis of the camera</source>
        <translation>Dreht das Licht um die senkrechte Achse der Kamera</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Factor on the radiance of the light</source>
        <translation>Faktor auf die Strahldichte des Lichts</translation>
    </message>
    <message>
        <source>Reflectance of the segment</source>
        <translation>Reflexionsgrad des Segments</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Replace the estimated ratio of reflected to arriving light</source>
        <translation>Das geschätzte Verhältnis von gespiegeltem zu ankommendem Licht ersetzen</translation>
    </message>
    <message>
        <source>Reflectance</source>
        <translation>Reflexionsgrad</translation>
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
        <source>Set reflectance</source>
        <translation>Reflexionsgrad setzen</translation>
    </message>
    <message>
        <source>Estimate reflectance</source>
        <translation>Reflexionsgrad schätzen</translation>
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
        <source> (yours)</source>
        <translation> (Ihr Wert)</translation>
    </message>
    <message>
        <source>. Only %1 sr are known both ways: a guess, better set it by hand.</source>
        <translation>. Nur %1 sr sind beidseitig bekannt: geschätzt, besser von Hand setzen.</translation>
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
        <source>Nothing is open.</source>
        <translation>Nichts ist geöffnet.</translation>
    </message>
    <message>
        <source>There is no light to show.</source>
        <translation>Es gibt kein Licht zu zeigen.</translation>
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
        <source>Its last usable state is shown: %1</source>
        <translation>Gezeigt wird der letzte brauchbare Stand: %1</translation>
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
        <source>How reflection grows towards grazing angles</source>
        <translation>Wie die Spiegelung zu streifenden Winkeln hin wächst</translation>
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
        <source>By hand</source>
        <translation>Von Hand</translation>
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
        <source>Pretend the object is this many times as large: larger is less translucent</source>
        <translation>So tun, als wäre das Objekt so viel größer: größer ist weniger transluzent</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Factor on the light that was scattered inside</source>
        <translation>Faktor auf das innen gestreute Licht</translation>
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
        <source>Nothing is open</source>
        <translation>Nichts ist geöffnet</translation>
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
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Dipole</source>
        <translation>Dipol</translation>
    </message>
    <message>
        <source>Better dipole</source>
        <translation>Besserer Dipol</translation>
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
        <source>How light spreads: the better dipole is nearer to the truth where much is absorbed</source>
        <translation>Wie sich Licht ausbreitet: Der bessere Dipol ist näher an der Wahrheit, wo viel absorbiert wird</translation>
    </message>
    <message>
        <source>Colour of a thick piece; changes absorption and scattering</source>
        <translation>Farbe eines dicken Stücks; ändert Absorption und Streuung</translation>
    </message>
    <message>
        <source>How far light gets below the surface [mm]; changes absorption and scattering</source>
        <translation>Wie weit Licht unter der Oberfläche kommt [mm]; ändert Absorption und Streuung</translation>
    </message>
    <message>
        <source>Change scattering model</source>
        <translation>Streumodell ändern</translation>
    </message>
    <message>
        <source>Change diffusion colour</source>
        <translation>Streufarbe ändern</translation>
    </message>
    <message>
        <source>Change free path</source>
        <translation>Freie Weglänge ändern</translation>
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
    <name>ui::ParamSlider</name>
    <message>
        <source>%1
Double-click the label to return to %2.</source>
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
        <source>Samples</source>
        <translation>Abtastungen</translation>
    </message>
    <message>
        <source>Light paths per pixel at which the picture is finished</source>
        <translation>Lichtpfade je Pixel, bei denen das Bild fertig ist</translation>
    </message>
    <message>
        <source>Bounces</source>
        <translation>Reflexionen</translation>
    </message>
    <message>
        <source>Surfaces a light path may visit; 1 lets folds mirror an object&apos;s old colour</source>
        <translation>Flächen, die ein Lichtpfad besuchen darf; bei 1 spiegeln Falten die alte Farbe des Objekts</translation>
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
        <source>Surface samples</source>
        <translation>Oberflächenpunkte</translation>
    </message>
    <message>
        <source>Translucency: points on front and back of a segment</source>
        <translation>Transluzenz: Punkte auf Vorder- und Rückseite eines Segments</translation>
    </message>
    <message>
        <source>Irradiance rays</source>
        <translation>Lichtpfade</translation>
    </message>
    <message>
        <source>Translucency: light paths per surface point</source>
        <translation>Transluzenz: Lichtpfade je Oberflächenpunkt</translation>
    </message>
    <message>
        <source>Smooth noise, keep edges</source>
        <translation>Rauschen glätten, Kanten erhalten</translation>
    </message>
    <message>
        <source>Edge-aware filter of the new picture, inside each segment</source>
        <translation>Kantenerhaltender Filter des neuen Bildes, innerhalb jedes Segments</translation>
    </message>
    <message>
        <source>Change filter</source>
        <translation>Filter ändern</translation>
    </message>
    <message>
        <source>Filter the depth map</source>
        <translation>Tiefenkarte filtern</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>The filter follows the noise that is measured in the depth map</source>
        <translation>Der Filter richtet sich nach dem Rauschen, das in der Tiefenkarte gemessen wird</translation>
    </message>
    <message>
        <source>Joint bilateral filter: smooth surfaces, sharp outlines</source>
        <translation>Gemeinsamer bilateraler Filter: glatte Flächen, scharfe Umrisse</translation>
    </message>
    <message>
        <source>Change depth filter</source>
        <translation>Tiefenfilter ändern</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
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
        <source>Colours further apart than this do not mix</source>
        <translation>Farben, die weiter auseinander liegen, mischen sich nicht</translation>
    </message>
    <message>
        <source>Depth range</source>
        <translation>Tiefenabstand</translation>
    </message>
    <message>
        <source>Depths that differ by a larger fraction do not mix</source>
        <translation>Tiefen mit größerem Verhältnis mischen sich nicht</translation>
    </message>
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
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>How exactly the light of all surface samples is summed</source>
        <translation>Wie genau das Licht aller Oberflächenproben summiert wird</translation>
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
        <source>Change translucency quality</source>
        <translation>Güte der Transluzenz ändern</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>Seconds after which the view is not refined any more; pictures that are exported have all samples</source>
        <translation>Sekunden, nach denen die Ansicht nicht weiter verfeinert wird; exportierte Bilder haben alle Abtastungen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
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
        <source>What a glossy segment shows are reflections: the light is read from them.</source>
        <translation>Ein glänzendes Segment zeigt Spiegelungen: Daraus wird das Licht gelesen.</translation>
    </message>
    <message>
        <source>Click selects a segment, double-click renames it, the box flags it as glossy.</source>
        <translation>Klick wählt ein Segment, Doppelklick benennt es um, das Kästchen markiert es als glänzend.</translation>
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
        <source>Glossy: what this segment shows are reflections</source>
        <translation>Glänzend: Was dieses Segment zeigt, sind Spiegelungen</translation>
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
