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
    <name>ToolRegistry</name>
    <message>
        <source>Pick and move</source>
        <translation>Wählen und bewegen</translation>
    </message>
    <message>
        <source>Click a segment to edit it, drag to move the picture</source>
        <translation>Segment zum Bearbeiten anklicken, Bild durch Ziehen bewegen</translation>
    </message>
    <message>
        <source>Smart select</source>
        <translation>Objektauswahl</translation>
    </message>
    <message>
        <source>Select an object by clicking it; Alt-click takes away, a drag points at several places</source>
        <translation>Objekt durch Anklicken auswählen; Alt-Klick nimmt weg, Ziehen zeigt auf mehrere Stellen</translation>
    </message>
    <message>
        <source>Selection brush</source>
        <translation>Auswahlpinsel</translation>
    </message>
    <message>
        <source>Paint what is selected</source>
        <translation>Auswahl malen</translation>
    </message>
    <message>
        <source>Selection eraser</source>
        <translation>Auswahlradierer</translation>
    </message>
    <message>
        <source>Erase what is selected</source>
        <translation>Auswahl wegradieren</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Select what is inside a line drawn freely</source>
        <translation>Auswählen, was in einer freihändig gezeichneten Linie liegt</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Vieleck</translation>
    </message>
    <message>
        <source>Select what is inside an outline of straight lines</source>
        <translation>Auswählen, was in einem Umriss aus geraden Linien liegt</translation>
    </message>
    <message>
        <source>Depth and plane</source>
        <translation>Tiefe und Ebene</translation>
    </message>
    <message>
        <source>Select what is equally far away, or a plane</source>
        <translation>Auswählen, was gleich weit entfernt ist, oder eine Ebene</translation>
    </message>
    <message>
        <source>Refine edge</source>
        <translation>Kante verfeinern</translation>
    </message>
    <message>
        <source>Paint over an outline to find it again in the photograph</source>
        <translation>Umriss übermalen, um ihn im Foto neu zu suchen</translation>
    </message>
    <message>
        <source>It needs depth, which this photograph does not have.</source>
        <translation>Dafür ist Tiefe nötig, die diese Fotografie nicht hat.</translation>
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
        <source>Project (.patina) or photograph to open.</source>
        <translation>Projekt (.patina) oder Foto, das geöffnet wird.</translation>
    </message>
    <message>
        <source>Part of the graphics device&apos;s name, or its index.</source>
        <translation>Teil des Namens des Grafikgeräts oder seine Nummer.</translation>
    </message>
    <message>
        <source>Changes the materials of objects in photographs with depth.</source>
        <translation>Ändert das Material von Objekten in Fotos mit Tiefe.</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>Its points lie on a line, which has no mirror plane.</source>
        <translation>Seine Punkte liegen auf einer Geraden, die keine Spiegelebene hat.</translation>
    </message>
    <message>
        <source>No mirror plane keeps most of it inside its silhouette.</source>
        <translation>Keine Spiegelebene hält den größten Teil innerhalb der Silhouette.</translation>
    </message>
    <message>
        <source>Its mirror image covers too little of its silhouette.</source>
        <translation>Sein Spiegelbild deckt zu wenig von der Silhouette ab.</translation>
    </message>
    <message>
        <source>None of its flat faces ends at its outline.</source>
        <translation>Keine seiner ebenen Flächen endet an seinem Umriss.</translation>
    </message>
    <message>
        <source>It runs out of the picture like a table or a wall, so it is a slab of constant thickness.</source>
        <translation>Es reicht wie ein Tisch oder eine Wand aus dem Bild hinaus und ist deshalb eine Platte von konstanter Dicke.</translation>
    </message>
    <message>
        <source>It has too few pixels with depth to estimate its shape.</source>
        <translation>Es hat zu wenige Pixel mit Tiefe, um seine Form zu schätzen.</translation>
    </message>
    <message>
        <source>None of its outline is visible, so no mirror can be spanned into it.</source>
        <translation>Von seinem Umriss ist nichts zu sehen, deshalb lässt sich kein Spiegel hineinspannen.</translation>
    </message>
    <message>
        <source>The back-side depth &quot;%1&quot; has %2 pixels, but the photograph has %3.</source>
        <translation>Die Tiefe der Rückseite „%1“ hat %2 Pixel, das Foto aber %3.</translation>
    </message>
    <message>
        <source>No glossy segment mirrors the light and no pixel is distant, so nothing is known of the light: the loaded map is all of it.</source>
        <translation>Kein glänzendes Segment spiegelt das Licht und kein Pixel ist weit entfernt, deshalb ist über das Licht nichts bekannt: Es kommt ganz aus der geladenen Karte.</translation>
    </message>
    <message>
        <source>No glossy segment mirrors the light and no pixel is distant, so nothing is known of the light: edits are lit as the shading suggests. Flag something glossy or load an environment map.</source>
        <translation>Kein glänzendes Segment spiegelt das Licht und kein Pixel ist weit entfernt, deshalb ist über das Licht nichts bekannt: Änderungen werden so beleuchtet, wie es die Schattierung nahelegt. Markieren Sie etwas als glänzend oder laden Sie eine Umgebungskarte.</translation>
    </message>
    <message>
        <source>No segment is flagged as glossy and no pixel is distant, so nothing is known of the light: the loaded map is all of it.</source>
        <translation>Kein Segment ist als glänzend markiert und kein Pixel ist weit entfernt, deshalb ist über das Licht nichts bekannt: Es kommt ganz aus der geladenen Karte.</translation>
    </message>
    <message>
        <source>No segment is flagged as glossy and no pixel is distant, so nothing is known of the light: edits are lit as the shading suggests. Flag something glossy or load an environment map.</source>
        <translation>Kein Segment ist als glänzend markiert und kein Pixel ist weit entfernt, deshalb ist über das Licht nichts bekannt: Änderungen werden so beleuchtet, wie es die Schattierung nahelegt. Markieren Sie etwas als glänzend oder laden Sie eine Umgebungskarte.</translation>
    </message>
    <message>
        <source>No segment is flagged as glossy: the light is known only from distant pixels, %1 % of all directions; the loaded map gives the rest. Flag something glossy to recover more.</source>
        <translation>Kein Segment ist als glänzend markiert: Das Licht ist nur aus weit entfernten Pixeln bekannt, %1 % aller Richtungen; den Rest gibt die geladene Karte. Markieren Sie etwas als glänzend, um mehr zu bestimmen.</translation>
    </message>
    <message>
        <source>No segment is flagged as glossy: the light is known only from distant pixels, %1 % of all directions; the rest is guessed. Flag something glossy to recover more.</source>
        <translation>Kein Segment ist als glänzend markiert: Das Licht ist nur aus weit entfernten Pixeln bekannt, %1 % aller Richtungen; der Rest ist geraten. Markieren Sie etwas als glänzend, um mehr zu bestimmen.</translation>
    </message>
    <message>
        <source>The camera clipped the light in %1 texels of the environment; their radiance is estimated from the blur around them. Use a photograph with more range (EXR) to get it right.</source>
        <translation>In %1 Texeln der Umgebung hat die Kamera das Licht abgeschnitten; seine Stärke ist aus der Unschärfe ringsum geschätzt. Ein Foto mit größerem Umfang (EXR) gibt sie richtig wieder.</translation>
    </message>
    <message>
        <source>Segment &quot;%1&quot; is glossy but has only %2 pixels with depth: too few to estimate its reflectance and the light from it.</source>
        <translation>Das Segment „%1“ ist glänzend, hat aber nur %2 Pixel mit Tiefe: zu wenige, um daraus seine Reflexion und das Licht zu schätzen.</translation>
    </message>
    <message>
        <source>Segment &quot;%1&quot; shows more light than it can mirror: it has colours of its own, so the light is not recovered from it. If it is a mirror, set its reflectance yourself.</source>
        <translation>Das Segment „%1“ zeigt mehr Licht, als es spiegeln kann: Es hat eigene Farben, deshalb wird das Licht nicht daraus bestimmt. Ist es ein Spiegel, geben Sie seine Reflexion selbst an.</translation>
    </message>
    <message>
        <source>Segment &quot;%1&quot; mirrors too little whose brightness is known (%2 sr), so its reflectance is a guess. Set it yourself.</source>
        <translation>Das Segment „%1“ spiegelt zu wenig, dessen Helligkeit bekannt ist (%2 sr), deshalb ist seine Reflexion geraten. Geben Sie sie selbst an.</translation>
    </message>
    <message>
        <source>Segment &quot;%1&quot; has no pixel with depth, so it cannot be edited. Give it depth or mark it again.</source>
        <translation>Das Segment „%1“ hat kein Pixel mit Tiefe und lässt sich deshalb nicht ändern. Geben Sie ihm Tiefe oder markieren Sie es neu.</translation>
    </message>
    <message>
        <source>Back side of &quot;%1&quot;: %2</source>
        <translation>Rückseite von „%1“: %2</translation>
    </message>
    <message>
        <source>There is no photograph to analyse. Load a colour picture with depth first.</source>
        <translation>Es gibt kein Foto, das analysiert werden könnte. Laden Sie zuerst ein Farbbild mit Tiefe.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Cannot write &quot;%1&quot;: %2.</source>
        <translation>„%1“ kann nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>Cannot write: the file name is empty.</source>
        <translation>Schreiben nicht möglich: Der Dateiname ist leer.</translation>
    </message>
    <message>
        <source>it is a folder, expected a file</source>
        <translation>es ist ein Ordner, erwartet wird eine Datei</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>the folder &quot;%1&quot; does not exist</source>
        <translation>den Ordner „%1“ gibt es nicht</translation>
    </message>
    <message>
        <source>the folder &quot;%1&quot; is not writable (%2)</source>
        <translation>in den Ordner „%1“ darf nicht geschrieben werden (%2)</translation>
    </message>
    <message>
        <source>Cannot read &quot;%1&quot;: %2.</source>
        <translation>„%1“ kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>die Datei gibt es nicht</translation>
    </message>
    <message>
        <source>the file is empty (0 bytes)</source>
        <translation>die Datei ist leer (0 Bytes)</translation>
    </message>
    <message>
        <source>Cannot read &quot;%1&quot;: it has %2 bytes, expected at most %3.</source>
        <translation>„%1“ kann nicht gelesen werden: Die Datei hat %2 Bytes, erwartet werden höchstens %3.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The work was cancelled.</source>
        <translation>Die Arbeit wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Cannot write &quot;%1&quot;: a Cryptomatte is stored in a .exr file.</source>
        <translation>„%1“ kann nicht geschrieben werden: Eine Cryptomatte wird in einer .exr-Datei gespeichert.</translation>
    </message>
    <message>
        <source>it is a deep image in tiles, expected scan lines</source>
        <translation>es ist ein „Deep“-Bild aus Kacheln, erwartet werden Zeilen</translation>
    </message>
    <message>
        <source>a color [r, g, b] or a number, the factor on the edit&apos;s own</source>
        <translation>eine Farbe [r, g, b] oder eine Zahl als Faktor auf die eigene Farbe</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty, expected the path of an image.</source>
        <translation>„%1“ ist leer, erwartet wird der Pfad eines Bildes.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs &quot;from&quot; or &quot;to&quot;: the values of &quot;%2&quot; where the mask is 0 and 1.</source>
        <translation>„%1“ braucht „from“ oder „to“: die Werte von „%2“, wo die Maske 0 und 1 ist.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a list [...].</source>
        <translation>„%1“ ist keine Liste [...].</translation>
    </message>
    <message>
        <source>&quot;%1.parameter&quot; is &quot;%2&quot;, which has a drive already.</source>
        <translation>„%1.parameter“ ist „%2“; dieser Parameter wird schon gesteuert.</translation>
    </message>
    <message>
        <source>In &quot;%1&quot; %2 of the pixels are negative, expected radiance of 0 or more: they count as 0. Repair the picture first.</source>
        <translation>In „%1“ sind %2 der Pixel negativ; erwartet werden Werte ab 0. Sie zählen als 0. Reparieren Sie zuerst das Bild.</translation>
    </message>
    <message>
        <source>it is a JPEG picture, whose compression changes label numbers; expected PNG, TIFF or EXR</source>
        <translation>es ist ein JPEG-Bild, dessen Kompression die Nummern der Segmente verändert; erwartet wird PNG, TIFF oder EXR</translation>
    </message>
    <message>
        <source>it is a colour picture, expected one number per pixel (grey or palette)</source>
        <translation>es ist ein Farbbild, erwartet wird eine Zahl pro Pixel (Graustufen oder Palette)</translation>
    </message>
    <message>
        <source>it contains the label %1, expected whole numbers from 0 to 65535</source>
        <translation>sie enthält die Nummer %1, erwartet werden ganze Zahlen von 0 bis 65535</translation>
    </message>
    <message>
        <source>it has %1 bytes, more than Patina accepts</source>
        <translation>sie hat %1 Bytes, mehr als Patina annimmt</translation>
    </message>
    <message>
        <source>its content is no image format that Patina reads (expected EXR, PNG, TIFF, JPEG, PFM or HDR)</source>
        <translation>der Inhalt hat kein Bildformat, das Patina liest (erwartet wird EXR, PNG, TIFF, JPEG, PFM oder HDR)</translation>
    </message>
    <message>
        <source>the file is truncated (JPEG data without an end)</source>
        <translation>die Datei ist abgeschnitten (JPEG-Daten ohne Ende)</translation>
    </message>
    <message>
        <source>the file is truncated (TIFF data beyond its end)</source>
        <translation>die Datei ist abgeschnitten (TIFF-Daten jenseits des Endes)</translation>
    </message>
    <message>
        <source>this build of OpenImageIO does not read %1 files</source>
        <translation>diese Version von OpenImageIO liest keine Dateien vom Typ %1</translation>
    </message>
    <message>
        <source>this build of OpenImageIO does not read %1 files from memory</source>
        <translation>diese Version von OpenImageIO liest Dateien vom Typ %1 nicht aus dem Speicher</translation>
    </message>
    <message>
        <source>Cannot read %1: %2.</source>
        <translation>%1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>the image size is %1</source>
        <translation>die Bildgröße ist %1</translation>
    </message>
    <message>
        <source>the image size is %1, expected at most %2 pixels a side and %3 megapixels</source>
        <translation>die Bildgröße ist %1, erwartet werden höchstens %2 Pixel pro Seite und %3 Megapixel</translation>
    </message>
    <message>
        <source>it is a volume of depth %1, expected a flat image</source>
        <translation>es ist ein Volumen der Tiefe %1, erwartet wird ein flaches Bild</translation>
    </message>
    <message>
        <source>it is a deep image (several samples per pixel), expected a flat one</source>
        <translation>es ist ein „Deep“-Bild (mehrere Werte pro Pixel), erwartet wird ein flaches</translation>
    </message>
    <message>
        <source>it has %1 channels, expected 1 to %2</source>
        <translation>sie hat %1 Kanäle, erwartet werden 1 bis %2</translation>
    </message>
    <message>
        <source>the header claims %1 pixels, but the file has only %2 bytes</source>
        <translation>der Kopf nennt %1 Pixel, die Datei hat aber nur %2 Bytes</translation>
    </message>
    <message>
        <source>Cannot write &quot;%1&quot;: the file name ends in &quot;%2&quot;, expected .exr, .png, .tif, .jpg or .hdr.</source>
        <translation>„%1“ kann nicht geschrieben werden: Der Dateiname endet auf „%2“, erwartet wird .exr, .png, .tif, .jpg oder .hdr.</translation>
    </message>
    <message>
        <source>Cannot write &quot;%1&quot;: %2 cannot be stored in a %3 file, expected %4.</source>
        <translation>„%1“ kann nicht geschrieben werden: %2 lassen sich nicht in einer %3-Datei speichern, erwartet wird %4.</translation>
    </message>
    <message>
        <source>this build of OpenImageIO does not write %1 files</source>
        <translation>diese Version von OpenImageIO schreibt keine Dateien vom Typ %1</translation>
    </message>
    <message>
        <source>measurements</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>.exr, .tif, .hdr or .png</source>
        <translation>.exr, .tif, .hdr oder .png</translation>
    </message>
    <message>
        <source>negative numbers</source>
        <translation>negative Zahlen</translation>
    </message>
    <message>
        <source>.exr, .tif, .png or .jpg</source>
        <translation>.exr, .tif, .png oder .jpg</translation>
    </message>
    <message>
        <source>labels</source>
        <translation>Segmentnummern</translation>
    </message>
    <message>
        <source>.png, .tif or .exr</source>
        <translation>.png, .tif oder .exr</translation>
    </message>
    <message>
        <source>its %1 image has no range, expected FloatMinValue &lt; FloatMaxValue in the XMP</source>
        <translation>das Bild „%1“ hat keinen Wertebereich, erwartet wird FloatMinValue &lt; FloatMaxValue im XMP</translation>
    </message>
    <message>
        <source>its %1 image has integers from IntMinValue %2 to IntMaxValue %3, expected a range</source>
        <translation>das Bild „%1“ hat ganze Zahlen von IntMinValue %2 bis IntMaxValue %3, erwartet wird ein Bereich</translation>
    </message>
    <message>
        <source>The camera states the depth inside &quot;%1&quot; as &quot;relative&quot;: its scale is approximate.</source>
        <translation>Die Kamera nennt die Tiefe in „%1“ „relative“: Ihr Maßstab ist ungefähr.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>%1 in its XMP is damaged, expected an image in base64</source>
        <translation>%1 in ihrem XMP ist beschädigt, erwartet wird ein Bild in Base64</translation>
    </message>
    <message>
        <source>%1 inside &quot;%2&quot;</source>
        <translation>%1 in „%2“</translation>
    </message>
    <message>
        <source>its depth has the format &quot;%1&quot;, expected RangeInverse or RangeLinear</source>
        <translation>die Tiefe hat das Format „%1“, erwartet wird RangeInverse oder RangeLinear</translation>
    </message>
    <message>
        <source>its depth goes from %1 (Near) to %2 (Far), expected 0 &lt; Near &lt; Far</source>
        <translation>die Tiefe reicht von %1 (Near) bis %2 (Far), erwartet wird 0 &lt; Near &lt; Far</translation>
    </message>
    <message>
        <source>its depth map has %1-bit values, expected 8 or 16-bit integers</source>
        <translation>die Tiefenkarte hat Werte mit %1 Bit, erwartet werden ganze Zahlen mit 8 oder 16 Bit</translation>
    </message>
    <message>
        <source>its depth image is in colour, expected grey</source>
        <translation>das Tiefenbild ist farbig, erwartet wird Grau</translation>
    </message>
    <message>
        <source>the image size is %1x%2, expected at most %3 pixels</source>
        <translation>die Bildgröße ist %1x%2, erwartet werden höchstens %3 Pixel</translation>
    </message>
    <message>
        <source>an image in it has no pixels</source>
        <translation>ein Bild darin hat keine Pixel</translation>
    </message>
    <message>
        <source>its colours have the primaries %1 and the transfer function %2 of ITU-T H.273 (16 is PQ, 18 is HLG), expected sRGB, a gamma, Rec.709, Rec.2020, linear light or an ICC profile</source>
        <translation>die Farben haben die Primärvalenzen %1 und die Übertragungsfunktion %2 nach ITU-T H.273 (16 ist PQ, 18 ist HLG), erwartet wird sRGB, ein Gamma, Rec.709, Rec.2020, lineares Licht oder ein ICC-Profil</translation>
    </message>
    <message>
        <source>its depth image says nothing about its range, expected XMP with an AuxiliaryImageType of disparity or depth</source>
        <translation>das Tiefenbild nennt seinen Wertebereich nicht, erwartet wird XMP mit dem AuxiliaryImageType „disparity“ oder „depth“</translation>
    </message>
    <message>
        <source>the auxiliary depth image of a HEIC file</source>
        <translation>das Tiefenbild einer HEIC-Datei</translation>
    </message>
    <message>
        <source>the sharp picture</source>
        <translation>das scharfe Bild</translation>
    </message>
    <message>
        <source>its XMP has no GDepth:Data, expected the depth map that GDepth:Format announces</source>
        <translation>in ihrem XMP fehlt GDepth:Data, erwartet wird die Tiefenkarte, die GDepth:Format ankündigt</translation>
    </message>
    <message>
        <source>the depth map</source>
        <translation>die Tiefenkarte</translation>
    </message>
    <message>
        <source>The depth inside &quot;%1&quot; has no unit: 1 is taken as a metre. Give the metres per unit to set the true scale.</source>
        <translation>Die Tiefe in „%1“ hat keine Einheit: 1 gilt als ein Meter. Geben Sie die Meter pro Einheit an, um den wahren Maßstab einzustellen.</translation>
    </message>
    <message>
        <source>a Google depth map (GDepth) in a JPEG</source>
        <translation>eine Google-Tiefenkarte (GDepth) in einem JPEG</translation>
    </message>
    <message>
        <source>the file is truncated: a picture of its index (MPF) lies beyond the end</source>
        <translation>die Datei ist abgeschnitten: Ein Bild ihres Verzeichnisses (MPF) liegt hinter dem Ende</translation>
    </message>
    <message>
        <source>the depth of an Apple camera in a JPEG (MPF)</source>
        <translation>die Tiefe einer Apple-Kamera in einem JPEG (MPF)</translation>
    </message>
    <message>
        <source>its extended XMP is incomplete: expected %1 bytes in successive parts, found %2</source>
        <translation>das erweiterte XMP ist unvollständig: Erwartet werden %1 Bytes in aufeinanderfolgenden Teilen, gefunden wurden %2</translation>
    </message>
    <message>
        <source>the file is truncated: its header segments have no end</source>
        <translation>die Datei ist abgeschnitten: Ihre Kopfsegmente haben kein Ende</translation>
    </message>
    <message>
        <source>The depth inside &quot;%1&quot; has no metric unit: 1 is taken as a millimetre. Give the metres per unit to set another scale.</source>
        <translation>Die Tiefe in „%1“ hat keine metrische Einheit: 1 gilt als ein Millimeter. Geben Sie die Meter pro Einheit an, um einen anderen Maßstab einzustellen.</translation>
    </message>
    <message>
        <source>The depth inside &quot;%1&quot; has no metric unit: 1 is taken as a metre. Give the metres per unit to set another scale.</source>
        <translation>Die Tiefe in „%1“ hat keine metrische Einheit: 1 gilt als ein Meter. Geben Sie die Meter pro Einheit an, um einen anderen Maßstab einzustellen.</translation>
    </message>
    <message>
        <source>none of the cameras in its XMP (XDM) has a depth map</source>
        <translation>keine der Kameras in ihrem XMP (XDM) hat eine Tiefenkarte</translation>
    </message>
    <message>
        <source>a depth map of extensible device metadata (XDM) in a JPEG</source>
        <translation>eine Tiefenkarte aus „extensible device metadata“ (XDM) in einem JPEG</translation>
    </message>
    <message>
        <source>the point cloud has no field &quot;%1&quot; of type F and size 4 or 8</source>
        <translation>die Punktwolke hat kein Feld „%1“ vom Typ F und der Größe 4 oder 8</translation>
    </message>
    <message>
        <source>only %1 points have x, y and z &gt; 0, expected %2 or more</source>
        <translation>nur %1 Punkte haben x, y und z &gt; 0, erwartet werden mindestens %2</translation>
    </message>
    <message>
        <source>its raster is not what a pin-hole camera sees (fx=%1, fy=%2, off by %3 pixels), expected x to the right, y downwards, z forward</source>
        <translation>das Raster ist nicht das einer Lochkamera (fx=%1, fy=%2, Abweichung %3 Pixel), erwartet wird x nach rechts, y nach unten, z nach vorn</translation>
    </message>
    <message>
        <source>the point cloud has no colours, expected a field &quot;rgb&quot; or &quot;rgba&quot; of size 4</source>
        <translation>die Punktwolke hat keine Farben, erwartet wird ein Feld „rgb“ oder „rgba“ der Größe 4</translation>
    </message>
    <message>
        <source>an organised point cloud (PCD)</source>
        <translation>eine geordnete Punktwolke (PCD)</translation>
    </message>
    <message>
        <source>the PCD header has no end, expected a line &quot;DATA ...&quot;</source>
        <translation>der PCD-Kopf hat kein Ende, erwartet wird eine Zeile „DATA ...“</translation>
    </message>
    <message>
        <source>has %1 values</source>
        <translation>hat %1 Werte</translation>
    </message>
    <message>
        <source>has no value</source>
        <translation>hat keinen Wert</translation>
    </message>
    <message>
        <source>the point cloud has WIDTH %1 and HEIGHT %2, expected a raster of points (HEIGHT of 2 or more)</source>
        <translation>die Punktwolke hat WIDTH %1 und HEIGHT %2, erwartet wird ein Raster von Punkten (HEIGHT mindestens 2)</translation>
    </message>
    <message>
        <source>the point cloud has %1x%2 points, expected at most %3</source>
        <translation>die Punktwolke hat %1x%2 Punkte, erwartet werden höchstens %3</translation>
    </message>
    <message>
        <source>is %1, expected WIDTH times HEIGHT, %2</source>
        <translation>ist %1, erwartet wird WIDTH mal HEIGHT, %2</translation>
    </message>
    <message>
        <source>the PCD header&apos;s %1 %2</source>
        <translation>%1 im PCD-Kopf %2</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, expected a whole number</source>
        <translation>ist „%1“, erwartet wird eine ganze Zahl</translation>
    </message>
    <message>
        <source>is %1, expected 1 to %2</source>
        <translation>ist %1, erwartet wird 1 bis %2</translation>
    </message>
    <message>
        <source>the PCD header&apos;s FIELDS, SIZE, TYPE and COUNT have %1, %2, %3 and %4 values, expected the same number</source>
        <translation>FIELDS, SIZE, TYPE und COUNT im PCD-Kopf haben %1, %2, %3 und %4 Werte, erwartet werden gleich viele</translation>
    </message>
    <message>
        <source>has the value %1, expected 1, 2, 4 or 8</source>
        <translation>hat den Wert %1, erwartet wird 1, 2, 4 oder 8</translation>
    </message>
    <message>
        <source>has the value %1, expected 1 to %2</source>
        <translation>hat den Wert %1, erwartet wird 1 bis %2</translation>
    </message>
    <message>
        <source>has the value &quot;%1&quot;, expected F, I or U</source>
        <translation>hat den Wert „%1“, erwartet wird F, I oder U</translation>
    </message>
    <message>
        <source>the PCD header&apos;s DATA is &quot;%1&quot;, expected ascii, binary or binary_compressed</source>
        <translation>DATA im PCD-Kopf ist „%1“, erwartet wird ascii, binary oder binary_compressed</translation>
    </message>
    <message>
        <source>the file is truncated: its points take %1 bytes, %2 are there</source>
        <translation>die Datei ist abgeschnitten: Ihre Punkte brauchen %1 Bytes, vorhanden sind %2</translation>
    </message>
    <message>
        <source>its points unpack to %1 bytes, expected %2</source>
        <translation>die Punkte ergeben entpackt %1 Bytes, erwartet werden %2</translation>
    </message>
    <message>
        <source>its compressed points (LZF) are damaged</source>
        <translation>die komprimierten Punkte (LZF) sind beschädigt</translation>
    </message>
    <message>
        <source>the file is truncated: expected %1 lines of points</source>
        <translation>die Datei ist abgeschnitten: Erwartet werden %1 Zeilen mit Punkten</translation>
    </message>
    <message>
        <source>point %1 has no value for the field &quot;%2&quot;</source>
        <translation>Punkt %1 hat keinen Wert für das Feld „%2“</translation>
    </message>
    <message>
        <source>its XMP is no well-formed XML: %1</source>
        <translation>ihr XMP ist kein wohlgeformtes XML: %1</translation>
    </message>
    <message>
        <source>a number of at least %1</source>
        <translation>eine Zahl ab %1</translation>
    </message>
    <message>
        <source>a number in [%1, %2]</source>
        <translation>eine Zahl in [%1, %2]</translation>
    </message>
    <message>
        <source>The value is %1, expected an object {...}.</source>
        <translation>Der Wert ist %1, erwartet wird ein Objekt {...}.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2, expected an object {...}.</source>
        <translation>„%1“ ist %2, erwartet wird ein Objekt {...}.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2, expected %3.</source>
        <translation>„%1“ ist %2, erwartet wird %3.</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>ein Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>a text without zero bytes</source>
        <translation>ein Text ohne Null-Bytes</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>three numbers [r, g, b]</source>
        <translation>drei Zahlen [r, g, b]</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; is missing.</source>
        <translation>Der Schlüssel „%1“ fehlt.</translation>
    </message>
    <message>
        <source>The key %1 is unknown, expected %2.</source>
        <translation>Der Schlüssel %1 ist unbekannt, erwartet wird %2.</translation>
    </message>
    <message>
        <source>The JSON text is nested deeper than %1.</source>
        <translation>Der JSON-Text ist tiefer als %1 verschachtelt.</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; occurs twice.</source>
        <translation>Der Schlüssel „%1“ kommt zweimal vor.</translation>
    </message>
    <message>
        <source>The JSON text is damaged: %1.</source>
        <translation>Der JSON-Text ist beschädigt: %1.</translation>
    </message>
    <message>
        <source>The mask &quot;%1&quot; has no number at (%2, %3), expected values from 0 to 1.</source>
        <translation>Die Maske „%1“ hat bei (%2, %3) keine Zahl, erwartet werden Werte von 0 bis 1.</translation>
    </message>
    <message>
        <source>The BRDF &quot;%1&quot; has no parameters of its own.</source>
        <translation>Die BRDF „%1“ hat keine eigenen Parameter.</translation>
    </message>
    <message>
        <source>The BRDF &quot;%1&quot; has the parameters %2.</source>
        <translation>Die BRDF „%1“ hat die Parameter %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is &quot;%2&quot;, expected one of %3.</source>
        <translation>„%1“ ist „%2“, erwartet wird eines von %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs exactly one of: &quot;preset&quot;; &quot;sigma_a&quot; with &quot;sigma_s_prime&quot;; &quot;diffuse_color&quot; with &quot;mean_free_path_mm&quot;.</source>
        <translation>„%1“ braucht genau eines von: „preset“; „sigma_a“ mit „sigma_s_prime“; „diffuse_color“ mit „mean_free_path_mm“.</translation>
    </message>
    <message>
        <source>a path after &quot;file:&quot;</source>
        <translation>ein Pfad hinter „file:“</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is left out: %2</source>
        <translation>„%1“ wird weggelassen: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs a BRDF with a Fresnel mode; &quot;%2&quot; has none.</source>
        <translation>„%1“ braucht eine BRDF mit Fresnel-Modus; „%2“ hat keinen.</translation>
    </message>
    <message>
        <source>Give &quot;%1&quot;, or &quot;eta&quot; and &quot;k&quot;, not both.</source>
        <translation>Geben Sie entweder „%1“ oder „eta“ und „k“ an, nicht beides.</translation>
    </message>
    <message>
        <source>[r, g, b] or &quot;estimated&quot;</source>
        <translation>[r, g, b] oder &quot;estimated&quot;</translation>
    </message>
    <message>
        <source>While loading &quot;%1&quot; for &quot;%2&quot;.</source>
        <translation>Beim Laden von „%1“ für „%2“.</translation>
    </message>
    <message>
        <source>The intrinsics %1 do not fit the colour image &quot;%2&quot; of %3 pixels: expected focal lengths of 0.01 to 1000 image sides and a principal point within 10 image sides.</source>
        <translation>Die Kameraparameter %1 passen nicht zum Farbbild „%2“ mit %3 Pixeln: Erwartet werden Brennweiten von 0,01 bis 1000 Bildseiten und ein Hauptpunkt innerhalb von 10 Bildseiten.</translation>
    </message>
    <message>
        <source>The horizontal field of view is %1 degrees, expected 0.1 to 177.</source>
        <translation>Der horizontale Bildwinkel ist %1 Grad, erwartet wird 0,1 bis 177.</translation>
    </message>
    <message>
        <source>The intrinsics are taken from &quot;%1&quot;: %2.</source>
        <translation>Die Kameraparameter stammen aus „%1“: %2.</translation>
    </message>
    <message>
        <source>The intrinsics in &quot;%1&quot; are ignored, because they fit no camera: %2.</source>
        <translation>Die Kameraparameter in „%1“ passen zu keiner Kamera und werden nicht verwendet: %2.</translation>
    </message>
    <message>
        <source>The focal length is taken from &quot;%1&quot;: %2 mm (35 mm equivalent).</source>
        <translation>Die Brennweite stammt aus „%1“: %2 mm (auf Kleinbild umgerechnet).</translation>
    </message>
    <message>
        <source>No focal length is given and &quot;%1&quot; does not state one: assuming a horizontal field of view of 60 degrees.</source>
        <translation>Es ist keine Brennweite angegeben und „%1“ nennt keine: Angenommen wird ein horizontaler Bildwinkel von 60 Grad.</translation>
    </message>
    <message>
        <source>The depth unit is %1, expected metres per stored unit, greater than 0.</source>
        <translation>Die Tiefeneinheit ist %1, erwartet werden Meter pro gespeicherter Einheit, größer als 0.</translation>
    </message>
    <message>
        <source>The depth image &quot;%1&quot; stores %2-bit integers, whose unit cannot be guessed: give the metres per stored unit.</source>
        <translation>Das Tiefenbild „%1“ enthält ganze Zahlen mit %2 Bit, deren Einheit sich nicht erraten lässt: Geben Sie die Meter pro gespeicherter Einheit an.</translation>
    </message>
    <message>
        <source>The depth in &quot;%1&quot; (%2) is enlarged to the colour image (%3).</source>
        <translation>Die Tiefe in „%1“ (%2) wird auf die Größe des Farbbilds (%3) gebracht.</translation>
    </message>
    <message>
        <source>The median depth in &quot;%1&quot; is %2 m with a unit of %3 m, expected %4 to %5 m: the unit is probably wrong. Give the metres per stored unit (0.001 for millimetres, 1 for metres), or the right kind of depth.</source>
        <translation>Die mittlere Tiefe in „%1“ ist %2 m bei einer Einheit von %3 m, erwartet wird %4 bis %5 m: Die Einheit ist wahrscheinlich falsch. Geben Sie die Meter pro gespeicherter Einheit an (0,001 für Millimeter, 1 für Meter) oder die richtige Art der Tiefe.</translation>
    </message>
    <message>
        <source>Depth image &quot;%1&quot; has no valid pixel: every value is zero, negative, not a number or beyond %2 m.</source>
        <translation>Das Tiefenbild „%1“ hat kein gültiges Pixel: Jeder Wert ist null, negativ, keine Zahl oder größer als %2 m.</translation>
    </message>
    <message>
        <source>Label map</source>
        <translation>Segmentkarte</translation>
    </message>
    <message>
        <source>Environment &quot;%1&quot; has %2 pixels, expected a latitude-longitude map, twice as wide as high.</source>
        <translation>Die Umgebungskarte „%1“ hat %2 Pixel, erwartet wird eine Längen-Breiten-Karte, doppelt so breit wie hoch.</translation>
    </message>
    <message>
        <source>the photograph</source>
        <translation>das Foto</translation>
    </message>
    <message>
        <source>Back depth image</source>
        <translation>Tiefenbild der Rückseite</translation>
    </message>
    <message>
        <source>it has no segments</source>
        <translation>es gibt keine Segmente</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>es gibt %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty, expected a name.</source>
        <translation>„%1“ ist leer, erwartet wird ein Name.</translation>
    </message>
    <message>
        <source>&quot;%1.label&quot; is %2, but the label map &quot;%3&quot; has no such label.</source>
        <translation>„%1.label“ ist %2, aber die Segmentkarte „%3“ enthält diese Nummer nicht.</translation>
    </message>
    <message>
        <source>&quot;%1.label&quot; is %2, which another segment has already.</source>
        <translation>„%1.label“ ist %2; diese Nummer hat schon ein anderes Segment.</translation>
    </message>
    <message>
        <source>&quot;%1.name&quot; is &quot;%2&quot;, which another segment has already.</source>
        <translation>„%1.name“ ist „%2“; so heißt schon ein anderes Segment.</translation>
    </message>
    <message>
        <source>The file is not a Patina project: expected &quot;format&quot;: &quot;patina&quot;.</source>
        <translation>Die Datei ist kein Patina-Projekt: Erwartet wird &quot;format&quot;: &quot;patina&quot;.</translation>
    </message>
    <message>
        <source>The project has version %1, this program reads up to version %2.</source>
        <translation>Das Projekt hat die Version %1, dieses Programm liest bis Version %2.</translation>
    </message>
    <message>
        <source>There is no segment &quot;%1&quot; in &quot;%2&quot;: %3.</source>
        <translation>In „%2“ gibt es kein Segment „%1“: %3.</translation>
    </message>
    <message>
        <source>While loading &quot;%1&quot;.</source>
        <translation>Beim Laden von „%1“.</translation>
    </message>
    <message>
        <source>Cannot write &quot;%1&quot;: a file or segment name in it is not valid UTF-8.</source>
        <translation>„%1“ kann nicht geschrieben werden: Ein Datei- oder Segmentname darin ist kein gültiges UTF-8.</translation>
    </message>
    <message>
        <source>There is no BRDF &quot;%1&quot;; known are: %2.</source>
        <translation>Es gibt keine BRDF „%1“; bekannt sind: %2.</translation>
    </message>
    <message>
        <source>This comment does not end.</source>
        <translation>Dieser Kommentar endet nicht.</translation>
    </message>
    <message>
        <source>The text is too long: more than %1 words and signs.</source>
        <translation>Der Text ist zu lang: mehr als %1 Wörter und Zeichen.</translation>
    </message>
    <message>
        <source>A name has more than %1 characters.</source>
        <translation>Ein Name hat mehr als %1 Zeichen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no int, uint or float.</source>
        <translation>„%1“ ist kein int, uint oder float.</translation>
    </message>
    <message>
        <source>Lines with # are not allowed here: no #include, #define, #extension or #version.</source>
        <translation>Zeilen mit # sind hier nicht erlaubt: kein #include, #define, #extension oder #version.</translation>
    </message>
    <message>
        <source>There is no % here; mod(x, y) does it for floats.</source>
        <translation>% gibt es hier nicht; mod(x, y) leistet dasselbe für float.</translation>
    </message>
    <message>
        <source>The sign %1 is not allowed here.</source>
        <translation>Das Zeichen %1 ist hier nicht erlaubt.</translation>
    </message>
    <message>
        <source>There is a character here that is not GLSL.</source>
        <translation>Hier steht ein Zeichen, das es in GLSL nicht gibt.</translation>
    </message>
    <message>
        <source>This statement is too long.</source>
        <translation>Diese Anweisung ist zu lang.</translation>
    </message>
    <message>
        <source>There are too many &quot;else&quot;.</source>
        <translation>Es gibt zu viele „else“.</translation>
    </message>
    <message>
        <source>Brackets are nested too deeply.</source>
        <translation>Die Klammern sind zu tief verschachtelt.</translation>
    </message>
    <message>
        <source>There is no bracket that this &quot;%1&quot; closes.</source>
        <translation>Es gibt keine Klammer, die dieses „%1“ schließt.</translation>
    </message>
    <message>
        <source>This &quot;%1&quot; is not closed.</source>
        <translation>Dieses „%1“ wird nicht geschlossen.</translation>
    </message>
    <message>
        <source>%1:%2: %3</source>
        <translation>%1:%2: %3</translation>
    </message>
    <message>
        <source>The file is no text in UTF-8.</source>
        <translation>Die Datei ist kein Text in UTF-8.</translation>
    </message>
    <message>
        <source>red</source>
        <translation>roten</translation>
    </message>
    <message>
        <source>green</source>
        <translation>grünen</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>blauen</translation>
    </message>
    <message>
        <source>expected a measured BRDF in MERL&apos;s binary format: dimensions 90, 90, 180, then %1 bytes of values</source>
        <translation>erwartet wird eine gemessene BRDF im Binärformat von MERL: Dimensionen 90, 90, 180, dann %1 Bytes Werte</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 bytes, %3, %4 bytes in all.</source>
        <translation>„%1“ hat %2 Bytes, %3, zusammen %4 Bytes.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has the dimensions %2, %3, %4, %5.</source>
        <translation>„%1“ hat die Dimensionen %2, %3, %4, %5.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: value %2 of the %3 plane is not a finite number; %4.</source>
        <translation>„%1“: Der Wert %2 der %3 Ebene ist keine endliche Zahl; %4.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not allowed here.</source>
        <translation>„%1“ ist hier nicht erlaubt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a name of GLSL or of the program.</source>
        <translation>„%1“ ist ein Name von GLSL oder des Programms.</translation>
    </message>
    <message>
        <source>Expected a function, a constant (const float a = 1.0;) or a parameter (uniform float a = 0.5;  // 0 to 1), found &quot;%1&quot;.</source>
        <translation>Erwartet wird eine Funktion, eine Konstante (const float a = 1.0;) oder ein Parameter (uniform float a = 0.5;  // 0 to 1), gefunden wurde „%1“.</translation>
    </message>
    <message>
        <source>Variables outside functions have to be const.</source>
        <translation>Variablen außerhalb von Funktionen müssen const sein.</translation>
    </message>
    <message>
        <source>This declaration does not end.</source>
        <translation>Diese Deklaration endet nicht.</translation>
    </message>
    <message>
        <source>This function has to be %1.</source>
        <translation>Diese Funktion muss %1 heißen.</translation>
    </message>
    <message>
        <source>Parameters are declared outside functions.</source>
        <translation>Parameter werden außerhalb von Funktionen deklariert.</translation>
    </message>
    <message>
        <source>The file lacks the function %1.</source>
        <translation>In der Datei fehlt die Funktion %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; calls itself; GLSL has no recursion.</source>
        <translation>„%1“ ruft sich selbst auf; GLSL kennt keine Rekursion.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too long with all that it calls: more than %2 words and signs.</source>
        <translation>„%1“ ist mit allem, was es aufruft, zu lang: mehr als %2 Wörter und Zeichen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs a condition in ( ).</source>
        <translation>„%1“ braucht eine Bedingung in ( ).</translation>
    </message>
    <message>
        <source>&quot;for&quot; needs (start; condition; step).</source>
        <translation>„for“ braucht (Anfang; Bedingung; Schritt).</translation>
    </message>
    <message>
        <source>Only a name can be indexed here.</source>
        <translation>Einen Index kann hier nur ein Name haben.</translation>
    </message>
    <message>
        <source>An array is declared as float a[3], without arrays in it.</source>
        <translation>Ein Feld wird als float a[3] deklariert und enthält keine Felder.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too large for an array, or no number; expected at most %2.</source>
        <translation>„%1“ ist zu groß für ein Feld oder keine Zahl; erwartet wird höchstens %2.</translation>
    </message>
    <message>
        <source>There are too many large arrays.</source>
        <translation>Es gibt zu viele große Felder.</translation>
    </message>
    <message>
        <source>The size of an array has to be a number.</source>
        <translation>Die Größe eines Feldes muss eine Zahl sein.</translation>
    </message>
    <message>
        <source>There is no field &quot;%1&quot;.</source>
        <translation>Es gibt kein Feld „%1“.</translation>
    </message>
    <message>
        <source>fresnel(cosine) needs uniform vec3 specular;</source>
        <translation>fresnel(cosine) braucht uniform vec3 specular;</translation>
    </message>
    <message>
        <source>A parameter is declared in one line: %1</source>
        <translation>Ein Parameter wird in einer Zeile deklariert: %1</translation>
    </message>
    <message>
        <source>A parameter is declared as %1 and a colour as uniform vec3 albedo; or uniform vec3 specular;</source>
        <translation>Ein Parameter wird als %1 deklariert und eine Farbe als uniform vec3 albedo; oder uniform vec3 specular;</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>A BRDF has at most %1 parameters.</source>
        <translation>Eine BRDF hat höchstens %1 Parameter.</translation>
    </message>
    <message>
        <source>A parameter cannot be called &quot;%1&quot;: edits have that key already.</source>
        <translation>Ein Parameter kann nicht „%1“ heißen: Diesen Schlüssel haben Änderungen schon.</translation>
    </message>
    <message>
        <source>The parameter &quot;%1&quot; is declared twice.</source>
        <translation>Der Parameter „%1“ ist zweimal deklariert.</translation>
    </message>
    <message>
        <source>The range of &quot;%1&quot; has to rise and to contain its initial value.</source>
        <translation>Der Bereich von „%1“ muss aufsteigen und den Anfangswert enthalten.</translation>
    </message>
    <message>
        <source>The range of &quot;%1&quot; is log and has to be above 0.</source>
        <translation>Der Bereich von „%1“ ist logarithmisch und muss über 0 liegen.</translation>
    </message>
    <message>
        <source>The label of &quot;%1&quot; lacks its closing quote.</source>
        <translation>Der Beschriftung von „%1“ fehlt das schließende Anführungszeichen.</translation>
    </message>
    <message>
        <source>The label of &quot;%1&quot; stands last and has 1 to %2 characters.</source>
        <translation>Die Beschriftung von „%1“ steht am Ende und hat 1 bis %2 Zeichen.</translation>
    </message>
    <message>
        <source>The range of &quot;%1&quot; is missing: %2</source>
        <translation>Der Bereich von „%1“ fehlt: %2</translation>
    </message>
    <message>
        <source>The unit of &quot;%1&quot; has more than 12 characters.</source>
        <translation>Die Einheit von „%1“ hat mehr als 12 Zeichen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not understood after the range of &quot;%2&quot;, expected log or a label in quotes.</source>
        <translation>„%1“ hinter dem Bereich von „%2“ ist unverständlich, erwartet wird log oder eine Beschriftung in Anführungszeichen.</translation>
    </message>
    <message>
        <source>The mask &quot;%1&quot; of &quot;%2&quot; in segment &quot;%3&quot; is %4, expected the photograph&apos;s size %5.</source>
        <translation>Die Maske „%1“ von „%2“ im Segment „%3“ hat die Größe %4, erwartet wird die des Fotos, %5.</translation>
    </message>
    <message>
        <source>The mask &quot;%1&quot; is %2 everywhere in the segment &quot;%3&quot;, so &quot;%4&quot; does not vary there. Is it the mask of another segment?</source>
        <translation>Die Maske „%1“ ist im Segment „%3“ überall %2, deshalb ändert sich „%4“ dort nicht. Gehört sie zu einem anderen Segment?</translation>
    </message>
    <message>
        <source>%1 was done on the CPU, because the device fails: %2</source>
        <translation>%1 lief auf der CPU, weil das Gerät versagt: %2</translation>
    </message>
    <message>
        <source>The depth filter</source>
        <translation>Der Tiefenfilter</translation>
    </message>
    <message>
        <source>The ray march</source>
        <translation>Die Strahlverfolgung</translation>
    </message>
    <message>
        <source>The fit of the surface</source>
        <translation>Die Anpassung der Oberfläche</translation>
    </message>
    <message>
        <source>The filling of directions</source>
        <translation>Das Ergänzen der Richtungen</translation>
    </message>
    <message>
        <source>The one object in &quot;%1&quot; is taken from the alpha channel: its pixels are those that are at least half opaque.</source>
        <translation>Das einzige Objekt in „%1“ kommt aus dem Alphakanal: Es sind die Pixel, die mindestens halb deckend sind.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a mask with soft edges, not a label map: its pixels from half of the maximum up are one segment.</source>
        <translation>„%1“ ist eine Maske mit weichen Rändern, keine Segmentkarte: Ihre Pixel ab der Hälfte des Höchstwerts sind ein Segment.</translation>
    </message>
    <message>
        <source>%1 of the labels in &quot;%2&quot; lie only between others, as soft edges do. Each of them is a segment: save the label map without antialiasing.</source>
        <translation>%1 der Nummern in „%2“ liegen nur zwischen anderen, wie bei weichen Rändern. Jede davon ist ein Segment: Speichern Sie die Segmentkarte ohne Kantenglättung.</translation>
    </message>
    <message>
        <source>The label of a segment is &quot;%1&quot;, expected 1 to %2.</source>
        <translation>Die Nummer eines Segments ist „%1“, erwartet wird 1 bis %2.</translation>
    </message>
    <message>
        <source>The project has %1 segments already, no label is free.</source>
        <translation>Das Projekt hat schon %1 Segmente, keine Nummer ist frei.</translation>
    </message>
    <message>
        <source>Nothing is selected, so there is no segment to make.</source>
        <translation>Nichts ist ausgewählt, also entsteht kein Segment.</translation>
    </message>
    <message>
        <source>The name of the segment is empty.</source>
        <translation>Der Name des Segments ist leer.</translation>
    </message>
    <message>
        <source>The point %1, %2 lies outside the photograph of %3 pixels.</source>
        <translation>Der Punkt %1, %2 liegt außerhalb des Fotos mit %3 Pixeln.</translation>
    </message>
    <message>
        <source>The point %1, %2 is both added and removed.</source>
        <translation>Der Punkt %1, %2 wird zugleich hinzugefügt und entfernt.</translation>
    </message>
    <message>
        <source>This needs %1 new segments, but only %2 labels are free.</source>
        <translation>Dafür sind %1 neue Segmente nötig, aber nur %2 Nummern sind frei.</translation>
    </message>
    <message>
        <source>There is no segment with the label %1.</source>
        <translation>Es gibt kein Segment mit der Nummer %1.</translation>
    </message>
    <message>
        <source>The segment &quot;%1&quot; is locked. Unlock it to change its pixels.</source>
        <translation>Das Segment „%1“ ist gesperrt. Entsperren Sie es, um seine Pixel zu ändern.</translation>
    </message>
    <message>
        <source>The segment &quot;%1&quot; is locked and stays as it is.</source>
        <translation>Das Segment „%1“ ist gesperrt und bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>%1 segments are locked and stay as they are.</source>
        <translation>%1 Segmente sind gesperrt und bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>The segment &quot;%1&quot; is locked and keeps its pixels.</source>
        <translation>Das Segment „%1“ ist gesperrt und behält seine Pixel.</translation>
    </message>
    <message>
        <source>%1 segments are locked and keep their pixels.</source>
        <translation>%1 Segmente sind gesperrt und behalten ihre Pixel.</translation>
    </message>
    <message>
        <source>The segment &quot;%1&quot; would lose all of its pixels, but it is edited. Lock it to keep it, or delete it.</source>
        <translation>Das Segment „%1“ würde alle seine Pixel verlieren, ist aber bearbeitet. Sperren Sie es, um es zu behalten, oder löschen Sie es.</translation>
    </message>
    <message>
        <source>The segment &quot;%1&quot; is gone, because it lost all of its pixels.</source>
        <translation>Das Segment „%1“ gibt es nicht mehr, weil es alle seine Pixel verloren hat.</translation>
    </message>
    <message>
        <source>%1 segments are gone, because they lost all of their pixels.</source>
        <translation>%1 Segmente gibt es nicht mehr, weil sie alle ihre Pixel verloren haben.</translation>
    </message>
    <message>
        <source>The selection and the segment &quot;%1&quot; have no pixel in common.</source>
        <translation>Die Auswahl und das Segment „%1“ haben kein Pixel gemeinsam.</translation>
    </message>
    <message>
        <source>Select at least two segments to merge them.</source>
        <translation>Wählen Sie mindestens zwei Segmente aus, um sie zu vereinen.</translation>
    </message>
    <message>
        <source>The material of &quot;%1&quot; is gone: &quot;%2&quot; keeps its own.</source>
        <translation>Das Material von „%1“ ist entfallen: „%2“ behält das eigene.</translation>
    </message>
    <message>
        <source>The materials of %1 segments are gone: &quot;%2&quot; keeps its own.</source>
        <translation>Die Materialien von %1 Segmenten sind entfallen: „%2“ behält das eigene.</translation>
    </message>
    <message>
        <source>The segment &quot;%1&quot; is in one piece.</source>
        <translation>Das Segment „%1“ besteht aus einem Stück.</translation>
    </message>
    <message>
        <source>No object was found that is not a segment already.</source>
        <translation>Es wurde kein Objekt gefunden, das nicht schon ein Segment ist.</translation>
    </message>
    <message>
        <source>No label is free for %1 of the objects.</source>
        <translation>Für %1 der Objekte ist keine Nummer frei.</translation>
    </message>
    <message>
        <source>There is no object in &quot;%1&quot;: all of it is 0.</source>
        <translation>In „%1“ gibt es kein Objekt: alles ist 0.</translation>
    </message>
    <message>
        <source>It is &quot;Depth unit&quot; under File &gt; New from photograph.</source>
        <translation>Sie steht als „Tiefeneinheit“ unter Datei &gt; Neu aus Fotografie.</translation>
    </message>
    <message>
        <source>They are &quot;Depth unit&quot; and &quot;Depth is&quot; under File &gt; New from photograph.</source>
        <translation>Sie stehen als „Tiefeneinheit“ und „Tiefe ist“ unter Datei &gt; Neu aus Fotografie.</translation>
    </message>
    <message>
        <source>&quot;Field of view&quot; under File &gt; New from photograph sets it.</source>
        <translation>„Bildwinkel“ unter Datei &gt; Neu aus Fotografie legt ihn fest.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; contains no depth map (%2), and no depth image is given. Objects can be selected by their colour, but materials cannot be changed: that needs a depth map.</source>
        <translation>„%1“ enthält keine Tiefenkarte (%2), und kein Tiefenbild ist angegeben. Objekte lassen sich nach ihrer Farbe auswählen, aber Materialien nicht ändern: dafür ist eine Tiefenkarte nötig.</translation>
    </message>
    <message>
        <source>The depth inside &quot;%1&quot; is read as &quot;%2&quot;, although the file says that it is &quot;%3&quot;.</source>
        <translation>Die Tiefe in „%1“ wird als „%2“ gelesen, obwohl sie laut Datei „%3“ ist.</translation>
    </message>
    <message>
        <source>In &quot;%1&quot; %2 of the pixels are not numbers, expected radiance of 0 or more: they count as 0. Repair the picture first.</source>
        <translation>In „%1“ sind %2 der Pixel keine Zahlen, erwartet wird eine Strahldichte von mindestens 0: Sie zählen als 0. Reparieren Sie zuerst das Bild.</translation>
    </message>
    <message>
        <source>In &quot;%1&quot; %2 of the pixels are infinite, expected radiance of 0 or more: they count as the largest finite value of the file, and as %3 at least.</source>
        <translation>In „%1“ sind %2 der Pixel unendlich, erwartet wird eine Strahldichte von mindestens 0: Sie zählen als der größte endliche Wert der Datei, mindestens aber als %3.</translation>
    </message>
    <message>
        <source>The colour is read from layer &quot;%1&quot; of &quot;%2&quot;, which has others: %3.</source>
        <translation>Die Farbe kommt aus der Ebene „%1“ von „%2“; weitere Ebenen sind: %3.</translation>
    </message>
    <message>
        <source>it has no channels R, G, B in any layer, only %1</source>
        <translation>in keiner Ebene gibt es Kanäle R, G, B, nur %1</translation>
    </message>
    <message>
        <source>it is a colour picture, expected one number per pixel</source>
        <translation>es ist ein Farbbild, erwartet wird eine Zahl je Pixel</translation>
    </message>
    <message>
        <source>The depth is channel &quot;%1&quot; of &quot;%2&quot;.</source>
        <translation>Die Tiefe ist der Kanal „%1“ von „%2“.</translation>
    </message>
    <message>
        <source>none of its channels is a depth map: %1</source>
        <translation>keiner der Kanäle ist eine Tiefenkarte: %1</translation>
    </message>
    <message>
        <source>The scale %1 in the header of &quot;%2&quot; is not applied: its values are taken as they are stored.</source>
        <translation>Der Maßstab %1 im Kopf von „%2“ wird nicht angewandt: Die Werte gelten, wie sie gespeichert sind.</translation>
    </message>
    <message>
        <source>it has Cryptomatte layers, which Patina does not read, and no layer of object numbers (IndexOB); its channels are %1</source>
        <translation>es enthält Cryptomatte-Ebenen, die Patina nicht liest, und keine Ebene mit Objektnummern (IndexOB); die Kanäle sind %1</translation>
    </message>
    <message>
        <source>it is a colour picture, expected one number per pixel, or a layer of object numbers (IndexOB); its channels are %1</source>
        <translation>es ist ein Farbbild, erwartet wird eine Zahl je Pixel oder eine Ebene mit Objektnummern (IndexOB); die Kanäle sind %1</translation>
    </message>
    <message>
        <source>Cannot write &quot;%1&quot;: a PNG holds measurements up to %2 here, and the largest is %3. Expected .exr or .tif.</source>
        <translation>„%1“ kann nicht geschrieben werden: Ein PNG fasst hier Messwerte bis %2, der größte ist %3. Erwartet wird .exr oder .tif.</translation>
    </message>
    <message>
        <source>positions in metres</source>
        <translation>Positionen in Metern</translation>
    </message>
    <message>
        <source>.exr or .tif</source>
        <translation>.exr oder .tif</translation>
    </message>
    <message>
        <source>depth channel of an EXR file</source>
        <translation>Tiefenkanal einer EXR-Datei</translation>
    </message>
    <message>
        <source>%1 size (%2) differs in shape from colour image size (%3); expected the same ratio of width to height.</source>
        <translation>%1: Das Format (%2) passt nicht zu dem des Farbbilds (%3); erwartet wird dasselbe Verhältnis von Breite zu Höhe.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; (%2) is reduced to the colour image (%3).</source>
        <translation>„%1“ (%2) wird auf das Farbbild (%3) verkleinert.</translation>
    </message>
    <message>
        <source>The pixels of &quot;%1&quot; are %2 times as wide as high; the camera accounts for it.</source>
        <translation>Die Pixel von „%1“ sind %2-mal so breit wie hoch; die Kamera berücksichtigt das.</translation>
    </message>
    <message>
        <source>%1 % of the values in &quot;%2&quot; are 65535, far from all others: they count as not measured.</source>
        <translation>%1 % der Werte in „%2“ sind 65535, weit entfernt von allen anderen: Sie gelten als nicht gemessen.</translation>
    </message>
    <message>
        <source>The graphics device has too little memory for this. (%1)</source>
        <translation>Das Grafikgerät hat dafür zu wenig Speicher. (%1)</translation>
    </message>
    <message>
        <source>The graphics device no longer answers. (%1)</source>
        <translation>Das Grafikgerät antwortet nicht mehr. (%1)</translation>
    </message>
    <message>
        <source>No graphics device can be used. (%1)</source>
        <translation>Kein Grafikgerät kann verwendet werden. (%1)</translation>
    </message>
    <message>
        <source>The graphics device failed. (%1)</source>
        <translation>Das Grafikgerät ist ausgefallen. (%1)</translation>
    </message>
    <message>
        <source>%1:1: It takes too long: trying it would take more than %2 seconds on this device.</source>
        <translation>%1:1: Dauert zu lange: ein Versuch würde auf diesem Gerät mehr als %2 Sekunden brauchen.</translation>
    </message>
    <message>
        <source>%1: It could not be tried: %2</source>
        <translation>%1: Konnte nicht ausprobiert werden: %2</translation>
    </message>
    <message>
        <source>The edits use %1 measured BRDFs; this graphics device has room for %2 at a time.</source>
        <translation>Die Bearbeitungen verwenden %1 gemessene BRDFs; auf diesem Grafikgerät ist gleichzeitig Platz für %2.</translation>
    </message>
    <message>
        <source>The edits use %1 BRDFs from .brdf.glsl files, expected at most %2 at a time.</source>
        <translation>Die Bearbeitungen verwenden %1 BRDFs aus .brdf.glsl-Dateien, möglich sind gleichzeitig höchstens %2.</translation>
    </message>
    <message>
        <source>Cannot read &quot;%1&quot;: it is a camera raw file, expected a developed picture. Develop it in a raw converter, and save a TIFF, PNG or JPEG.</source>
        <translation>„%1“ kann nicht gelesen werden: Es ist eine Rohdatei einer Kamera, erwartet wird ein entwickeltes Bild. Entwickeln Sie sie in einem Rohkonverter, und speichern Sie ein TIFF, PNG oder JPEG.</translation>
    </message>
    <message>
        <source>The depth inside &quot;%1&quot; has the unit &quot;%2&quot;, which is not known: 1 is taken as a metre. Give the metres per unit to set the true scale.</source>
        <translation>Die Tiefe in „%1“ hat die Einheit „%2“, die nicht bekannt ist: 1 gilt als ein Meter. Geben Sie die Meter pro Einheit an, um den wahren Maßstab einzustellen.</translation>
    </message>
    <message>
        <source>The index (MPF) of &quot;%1&quot; names a further picture that is not in the file: another program dropped it when it saved the photograph, and the depth with it if that was there. Take the original file, or give a depth map.</source>
        <translation>Das Verzeichnis (MPF) von „%1“ nennt ein weiteres Bild, das nicht in der Datei ist: Ein anderes Programm hat es beim Speichern des Fotos weggelassen, und mit ihm die Tiefe, falls sie dort war. Nehmen Sie die Originaldatei, oder geben Sie eine Tiefenkarte an.</translation>
    </message>
    <message>
        <source>it is a photograph without depth, expected a depth map</source>
        <translation>Es ist ein Foto ohne Tiefe, erwartet wird eine Tiefenkarte</translation>
    </message>
    <message>
        <source>it is a photograph whose depth another program dropped</source>
        <translation>Es ist ein Foto, dessen Tiefe ein anderes Programm weggelassen hat</translation>
    </message>
    <message>
        <source>The values of &quot;%1&quot; fill the range from 0 to %2 exactly, so this is probably relative depth, as networks give it, often with the largest value nearest. For that, give the kind &quot;inverse&quot; and a unit.</source>
        <translation>Die Werte von „%1“ füllen den Bereich von 0 bis %2 genau aus; wahrscheinlich ist es relative Tiefe, wie neuronale Netze sie liefern, bei der oft der größte Wert am nächsten liegt. Geben Sie dafür die Art „inverse“ und eine Einheit an.</translation>
    </message>
    <message>
        <source>Item:%1 in its XMP is &quot;%2&quot;, expected a number of bytes within the file</source>
        <translation>Item:%1 in ihrem XMP ist „%2“, erwartet wird eine Anzahl von Bytes innerhalb der Datei</translation>
    </message>
    <message>
        <source>the file is truncated: the photograph has no end</source>
        <translation>die Datei ist abgeschnitten: Das Foto hat kein Ende</translation>
    </message>
    <message>
        <source>the file is truncated: %1 lies beyond the end</source>
        <translation>die Datei ist abgeschnitten: %1 liegt hinter dem Ende</translation>
    </message>
    <message>
        <source>%1 is not where the list in its XMP puts it, expected a whole JPEG or PNG picture in %2 bytes from byte %3</source>
        <translation>%1 ist nicht dort, wo die Liste in ihrem XMP es angibt, erwartet wird ein vollständiges JPEG- oder PNG-Bild in %2 Bytes ab Byte %3</translation>
    </message>
    <message>
        <source>the list of pictures in its XMP has no &quot;%1&quot;, expected %2</source>
        <translation>die Liste der Bilder in ihrem XMP enthält kein „%1“, erwartet wird %2</translation>
    </message>
    <message>
        <source>its depth map (Dynamic Depth) is a mask of the person in front (Segmentation), not depth</source>
        <translation>ihre Tiefenkarte (Dynamic Depth) ist eine Maske der Person im Vordergrund (Segmentation), keine Tiefe</translation>
    </message>
    <message>
        <source>none of the cameras in its XMP (Dynamic Depth) has a depth map</source>
        <translation>keine der Kameras in ihrem XMP (Dynamic Depth) hat eine Tiefenkarte</translation>
    </message>
    <message>
        <source>a depth map of Android (Dynamic Depth) in a JPEG</source>
        <translation>eine Tiefenkarte von Android (Dynamic Depth) in einem JPEG</translation>
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
    <name>samples</name>
    <message>
        <source>Studio: a satin vase and a golden bag</source>
        <translation>Studio: eine seidenmatte Vase und ein goldener Beutel</translation>
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
        <source>Smooth surfaces and keep outlines sharp (edge-avoiding filter)</source>
        <translation>Flächen glätten, Umrisse scharf lassen (kantenerhaltender Filter)</translation>
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
    <message>
        <source>Dipole</source>
        <translation>Dipol</translation>
    </message>
    <message>
        <source>Better dipole</source>
        <translation>Besserer Dipol</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Show the segment with its new material</source>
        <translation>Das Segment mit seinem neuen Material zeigen</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Protect the segment&apos;s pixels from being changed</source>
        <translation>Die Pixel des Segments vor Änderungen schützen</translation>
    </message>
</context>
<context>
    <name>tasks</name>
    <message>
        <source>Working</source>
        <translation>In Arbeit</translation>
    </message>
    <message>
        <source>Loading the photograph</source>
        <translation>Foto wird geladen</translation>
    </message>
    <message>
        <source>Recovering depth</source>
        <translation>Tiefe wird bestimmt</translation>
    </message>
    <message>
        <source>Computing normals</source>
        <translation>Normalen werden berechnet</translation>
    </message>
    <message>
        <source>Inventing back sides</source>
        <translation>Rückseiten werden ergänzt</translation>
    </message>
    <message>
        <source>Building depth layers</source>
        <translation>Tiefenschichten werden aufgebaut</translation>
    </message>
    <message>
        <source>Estimating reflectance</source>
        <translation>Reflexion wird geschätzt</translation>
    </message>
    <message>
        <source>Recovering the environment</source>
        <translation>Umgebungslicht wird bestimmt</translation>
    </message>
    <message>
        <source>Separating texture from shading</source>
        <translation>Textur und Schattierung werden getrennt</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Rendern</translation>
    </message>
    <message>
        <source>Filtering the picture</source>
        <translation>Bild wird gefiltert</translation>
    </message>
    <message>
        <source>Summing diffuse light</source>
        <translation>Diffuses Licht wird summiert</translation>
    </message>
    <message>
        <source>Running benchmarks</source>
        <translation>Messungen laufen</translation>
    </message>
    <message>
        <source>Finding regions to select</source>
        <translation>Auswählbare Bereiche werden gesucht</translation>
    </message>
</context>
<context>
    <name>ui</name>
    <message>
        <source>Vulkan is not available on this system (error %1), so the picture cannot be shown.</source>
        <translation>Vulkan ist auf diesem System nicht verfügbar (Fehler %1), deshalb kann das Bild nicht gezeigt werden.</translation>
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
    <name>ui::BrushTool</name>
    <message>
        <source>Paint over the object. Alt erases; [ and ] change the brush.</source>
        <translation>Übermalen Sie das Objekt. Alt radiert; [ und ] ändern den Pinsel.</translation>
    </message>
    <message>
        <source>Paint over what is selected wrongly. Alt paints; [ and ] change the brush.</source>
        <translation>Übermalen Sie, was falsch ausgewählt ist. Alt malt; [ und ] ändern den Pinsel.</translation>
    </message>
    <message>
        <source>Select something first; then paint over its outline.</source>
        <translation>Wählen Sie zuerst etwas aus; übermalen Sie dann den Umriss.</translation>
    </message>
    <message>
        <source>Paint over the outline where it is wrong: it is found again there.</source>
        <translation>Übermalen Sie den Umriss, wo er falsch ist: Dort wird er neu gesucht.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Radius of the brush in pixels of the picture</source>
        <translation>Radius des Pinsels in Bildpunkten</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>Part of the brush that paints everything; the rim around it paints only what looks like the part inside</source>
        <translation>Teil des Pinsels, der alles bemalt; der Rand darum bemalt nur, was so aussieht wie das Innere</translation>
    </message>
    <message>
        <source>Stop at depth edges</source>
        <translation>An Tiefenkanten anhalten</translation>
    </message>
    <message>
        <source>Paint only the surface that is under the middle of the brush</source>
        <translation>Nur die Oberfläche bemalen, die unter der Mitte des Pinsels liegt</translation>
    </message>
    <message>
        <source>Erase selection</source>
        <translation>Auswahl radieren</translation>
    </message>
    <message>
        <source>Paint selection</source>
        <translation>Auswahl malen</translation>
    </message>
    <message>
        <source>Refine edge</source>
        <translation>Kante verfeinern</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
</context>
<context>
    <name>ui::Canvas</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The graphics device is lost whenever this picture is drawn. Your edits are safe: undo the last one, or save and restart Patina with another device.</source>
        <translation>Das Grafikgerät fällt aus, sobald dieses Bild gezeichnet wird. Ihre Änderungen sind sicher: Machen Sie die letzte rückgängig, oder speichern Sie und starten Sie Patina mit einem anderen Gerät neu.</translation>
    </message>
</context>
<context>
    <name>ui::CanvasRenderer</name>
    <message>
        <source>The graphics device was lost and is being restarted. Your edits are safe.</source>
        <translation>Das Grafikgerät ist ausgefallen und wird neu gestartet. Ihre Änderungen sind sicher.</translation>
    </message>
    <message>
        <source>The graphics device is gone. Your edits are safe: save them and restart Patina.</source>
        <translation>Das Grafikgerät ist nicht mehr da. Ihre Änderungen sind sicher: Speichern Sie sie und starten Sie Patina neu.</translation>
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
    <name>ui::DepthTool</name>
    <message>
        <source>The photograph has no depth to select by.</source>
        <translation>Das Foto hat keine Tiefe, nach der ausgewählt werden könnte.</translation>
    </message>
    <message>
        <source>Click a plane, such as a wall or a table.</source>
        <translation>Klicken Sie auf eine Ebene, etwa eine Wand oder einen Tisch.</translation>
    </message>
    <message>
        <source>Click something to select all that is as far away.</source>
        <translation>Klicken Sie auf etwas, um alles auszuwählen, was gleich weit entfernt ist.</translation>
    </message>
    <message>
        <source>Kind of depth selection</source>
        <translation>Art der Tiefenauswahl</translation>
    </message>
    <message>
        <source>Select what is equally far away, or what lies on one plane</source>
        <translation>Auswählen, was gleich weit entfernt ist oder was auf einer Ebene liegt</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>How far depth may be off, in parts of the distance</source>
        <translation>Wie weit die Tiefe abweichen darf, als Teil der Entfernung</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Round the outline off over this many pixels, and drop specks</source>
        <translation>Umriss über so viele Bildpunkte abrunden und Krümel weglassen</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Zusammenhängend</translation>
    </message>
    <message>
        <source>Select only the piece that is clicked</source>
        <translation>Nur das angeklickte Stück auswählen</translation>
    </message>
    <message>
        <source>Click inside the picture.</source>
        <translation>Klicken Sie in das Bild.</translation>
    </message>
    <message>
        <source>There is no depth at this pixel.</source>
        <translation>An diesem Bildpunkt gibt es keine Tiefe.</translation>
    </message>
    <message>
        <source>Select by depth</source>
        <translation>Nach Tiefe auswählen</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
</context>
<context>
    <name>ui::DepthView</name>
    <message>
        <source>Depth in space</source>
        <translation>Tiefe im Raum</translation>
    </message>
    <message>
        <source>Drag to turn, wheel to zoom, double-click for the first view; or arrow keys, + and -, Home</source>
        <translation>Ziehen dreht, das Mausrad zoomt, Doppelklick zeigt die erste Ansicht; oder Pfeiltasten, + und -, Pos1</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
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
    <message>
        <source>The recovered light is tied to the photograph: it already has the direction and the strength that were photographed. Load an environment map to turn or scale the light.</source>
        <translation>Das gewonnene Licht ist an das Foto gebunden: Es hat schon die Richtung und die Stärke, die fotografiert wurden. Laden Sie eine Umgebungskarte, um das Licht zu drehen oder zu skalieren.</translation>
    </message>
</context>
<context>
    <name>ui::LassoTool</name>
    <message>
        <source>Draw around the object in one stroke.</source>
        <translation>Umfahren Sie das Objekt in einem Zug.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Analysing: %1, %2 %</source>
        <translation>Analyse: %1, %2 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Device in use</source>
        <translation>Verwendetes Gerät</translation>
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
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
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
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
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
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>&amp;Brighter</source>
        <translation>&amp;Heller</translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation>&amp;Dunkler</translation>
    </message>
    <message>
        <source>&amp;Normal exposure</source>
        <translation>&amp;Normale Belichtung</translation>
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
        <source>&amp;About Patina</source>
        <translation>Ü&amp;ber Patina</translation>
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
        <source>  Exposure </source>
        <translation>  Belichtung </translation>
    </message>
    <message>
        <source>Exposure of the view</source>
        <translation>Belichtung der Ansicht</translation>
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
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
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
        <source>The canvas is disabled.</source>
        <translation>Die Bildansicht ist abgeschaltet.</translation>
    </message>
    <message>
        <source>Value under the pointer</source>
        <translation>Wert unter dem Zeiger</translation>
    </message>
    <message>
        <source>Current work</source>
        <translation>Aktuelle Arbeit</translation>
    </message>
    <message>
        <source>Zoom: screen pixels per picture pixel</source>
        <translation>Zoom: Bildschirmpixel pro Bildpixel</translation>
    </message>
    <message>
        <source>Rendering progress</source>
        <translation>Fortschritt des Bildes</translation>
    </message>
    <message>
        <source>Render on (takes effect after restart):</source>
        <translation>Rechnen auf (wirkt nach dem Neustart):</translation>
    </message>
    <message>
        <source>Render the edited photograph with all samples and save it</source>
        <translation>Das geänderte Foto mit allen Samples rechnen und speichern</translation>
    </message>
    <message>
        <source>Quit Patina</source>
        <translation>Patina beenden</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Die letzte Änderung rückgängig machen</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>Die zuletzt rückgängig gemachte Änderung wiederherstellen</translation>
    </message>
    <message>
        <source>Show one picture pixel per screen pixel</source>
        <translation>Ein Bildpixel pro Bildschirmpixel zeigen</translation>
    </message>
    <message>
        <source>Enlarge the view</source>
        <translation>Ansicht vergrößern</translation>
    </message>
    <message>
        <source>Shrink the view</source>
        <translation>Ansicht verkleinern</translation>
    </message>
    <message>
        <source>Brighten the view by a third of a stop; the picture stays the same</source>
        <translation>Ansicht um eine Drittelblende aufhellen; das Bild bleibt gleich</translation>
    </message>
    <message>
        <source>Darken the view by a third of a stop; the picture stays the same</source>
        <translation>Ansicht um eine Drittelblende abdunkeln; das Bild bleibt gleich</translation>
    </message>
    <message>
        <source>Show the picture at its own exposure</source>
        <translation>Das Bild mit seiner eigenen Belichtung zeigen</translation>
    </message>
    <message>
        <source>Show the scale of the selected translucent object</source>
        <translation>Den Maßstab des ausgewählten durchscheinenden Objekts zeigen</translation>
    </message>
    <message>
        <source>Show changes without refining them, so that the device stays idle</source>
        <translation>Änderungen zeigen, aber nicht verfeinern, damit das Gerät ruht</translation>
    </message>
    <message>
        <source>Read how to use Patina</source>
        <translation>Die Anleitung zu Patina lesen</translation>
    </message>
    <message>
        <source>Show version and graphics device</source>
        <translation>Version und Grafikgerät zeigen</translation>
    </message>
    <message>
        <source>Layer shown</source>
        <translation>Gezeigte Ebene</translation>
    </message>
    <message>
        <source>Choose what the canvas shows. Hold C or the right mouse button to see the original.</source>
        <translation>Wählen, was die Bildansicht zeigt. Solange C oder die rechte Maustaste gedrückt ist, erscheint das Original.</translation>
    </message>
    <message>
        <source>Brightness of the view in stops; the picture stays the same</source>
        <translation>Helligkeit der Ansicht in Blendenstufen; das Bild bleibt gleich</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Patina %1&lt;/h3&gt;&lt;p&gt;Changes the materials of objects in a photograph.&lt;/p&gt;&lt;p&gt;After S. Bergmann, T. Ritschel, C. Dachsbacher, &lt;i&gt;Interactive Appearance Editing in RGB-D Images&lt;/i&gt;, VMV 2014.&lt;/p&gt;&lt;p&gt;Device: %2&lt;br&gt;Qt %3&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Patina %1&lt;/h3&gt;&lt;p&gt;Ändert das Material von Objekten in einem Foto.&lt;/p&gt;&lt;p&gt;Nach S. Bergmann, T. Ritschel, C. Dachsbacher, &lt;i&gt;Interactive Appearance Editing in RGB-D Images&lt;/i&gt;, VMV 2014.&lt;/p&gt;&lt;p&gt;Gerät: %2&lt;br&gt;Qt %3&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder neuer.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Please wait until the current task has finished.</source>
        <translation>Bitte warten Sie, bis die laufende Arbeit fertig ist.</translation>
    </message>
    <message>
        <source>The project has unsaved changes. Save them first?</source>
        <translation>Das Projekt hat ungespeicherte Änderungen. Zuerst speichern?</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>%1 wird geladen</translation>
    </message>
    <message>
        <source>&amp;Notices</source>
        <translation>&amp;Hinweise</translation>
    </message>
    <message>
        <source>List what was found in the files and assumed by the analysis</source>
        <translation>Auflisten, was in den Dateien gefunden und von der Analyse angenommen wurde</translation>
    </message>
    <message>
        <source>Files of &quot;%1&quot; were found in another folder. Save the project to keep their new places.</source>
        <translation>Dateien von „%1“ wurden in einem anderen Ordner gefunden. Speichern Sie das Projekt, um die neuen Orte zu behalten.</translation>
    </message>
    <message>
        <source>Choose where the first one is now. The others are looked for beside it.</source>
        <translation>Wählen Sie, wo die erste jetzt ist. Die anderen werden daneben gesucht.</translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>Suchen…</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>%1 (%1);;All files (*)</source>
        <translation>%1 (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Files of &quot;%1&quot; cannot be found:</source>
        <translation>Dateien von „%1“ wurden nicht gefunden:</translation>
    </message>
    <message>
        <source>&amp;New from photograph…</source>
        <translation>&amp;Neu aus Fotografie…</translation>
    </message>
    <message>
        <source>Start a project from a photograph and its depth</source>
        <translation>Ein Projekt aus einer Fotografie und ihrer Tiefe beginnen</translation>
    </message>
    <message>
        <source>Open a photograph or a project</source>
        <translation>Eine Fotografie oder ein Projekt öffnen</translation>
    </message>
    <message>
        <source>&amp;Deselect segment</source>
        <translation>Segment &amp;abwählen</translation>
    </message>
    <message>
        <source>Edit no segment</source>
        <translation>Kein Segment bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>A&amp;uswahl</translation>
    </message>
    <message>
        <source>Projects and photographs (*.patina *.exr *.jpg *.jpeg *.heic *.heif *.png *.tif *.tiff *.hdr *.pfm *.pcd);;Patina projects (*.patina);;All files (*)</source>
        <translation>Projekte und Fotografien (*.patina *.exr *.jpg *.jpeg *.heic *.heif *.png *.tif *.tiff *.hdr *.pfm *.pcd);;Patina-Projekte (*.patina);;Alle Dateien (*)</translation>
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
    <message>
        <source>Pick diffuse colour</source>
        <translation>Diffuse Farbe aufnehmen</translation>
    </message>
    <message>
        <source>Pick specular colour</source>
        <translation>Spiegelfarbe aufnehmen</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Take the colour of a surface, without its shading, by a click in the picture (Esc: cancel)</source>
        <translation>Die Farbe einer Oberfläche ohne ihre Schattierung durch einen Klick ins Bild übernehmen (Esc: abbrechen)</translation>
    </message>
    <message>
        <source>This photograph has no depth, so a material would change nothing. To change materials, open it again under File &gt; New from photograph and choose its depth map as &quot;Depth&quot;.</source>
        <translation>Diese Fotografie hat keine Tiefe, deshalb würde ein Material nichts ändern. Um Materialien zu ändern, öffnen Sie sie unter Datei &gt; Neu aus Fotografie noch einmal und wählen Sie ihre Tiefenkarte als „Tiefe“.</translation>
    </message>
</context>
<context>
    <name>ui::NavigateTool</name>
    <message>
        <source>Nothing can be edited yet: choose Smart select and click an object.</source>
        <translation>Noch lässt sich nichts bearbeiten: Wählen Sie die Objektauswahl und klicken Sie auf ein Objekt.</translation>
    </message>
    <message>
        <source>Click a segment to edit it. Drag moves the picture, the wheel zooms.</source>
        <translation>Klicken Sie auf ein Segment, um es zu bearbeiten. Ziehen bewegt das Bild, das Mausrad zoomt.</translation>
    </message>
</context>
<context>
    <name>ui::NewPhotoDialog</name>
    <message>
        <source>Pictures (*.exr *.png *.jpg *.jpeg *.tif *.tiff *.hdr *.pfm);;All files (*)</source>
        <translation>Bilder (*.exr *.png *.jpg *.jpeg *.tif *.tiff *.hdr *.pfm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
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
    <message>
        <source>Colour picture; EXR and HDR files are read as linear light</source>
        <translation>Farbbild; EXR- und HDR-Dateien werden als lineares Licht gelesen</translation>
    </message>
    <message>
        <source>Depth map of the same view. Leave empty if the photograph contains depth (portrait photos of phones, EXR with a Z channel, point clouds).</source>
        <translation>Tiefenkarte derselben Ansicht. Leer lassen, wenn das Foto die Tiefe enthält (Porträtfotos von Handys, EXR mit Kanal Z, Punktwolken).</translation>
    </message>
    <message>
        <source>Metres per stored unit. Automatic uses what the photograph states, otherwise 1 for floating-point files and 0.001 for 16-bit files.</source>
        <translation>Meter pro gespeicherter Einheit. „Automatisch“ nimmt die Angabe des Fotos, sonst 1 für Gleitkomma-Dateien und 0,001 für 16-Bit-Dateien.</translation>
    </message>
    <message>
        <source>What the photograph&apos;s file contains</source>
        <translation>Was die Datei des Fotos enthält</translation>
    </message>
    <message>
        <source>Label map: one number per object, 0 for none; or a black-and-white mask of one object</source>
        <translation>Segmentkarte: eine Zahl je Objekt, 0 für keines; oder eine schwarzweiße Maske eines Objekts</translation>
    </message>
    <message>
        <source>Why the project cannot be made</source>
        <translation>Warum das Projekt nicht angelegt werden kann</translation>
    </message>
    <message>
        <source>Reading the photograph…</source>
        <translation>Das Foto wird gelesen…</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>field of view %1°</source>
        <translation>Bildwinkel %1°</translation>
    </message>
    <message>
        <source>no field of view stated</source>
        <translation>kein Bildwinkel angegeben</translation>
    </message>
    <message>
        <source>no depth inside</source>
        <translation>keine Tiefe enthalten</translation>
    </message>
    <message>
        <source>depth inside, %1 × %2 pixels: %3</source>
        <translation>Tiefe enthalten, %1 × %2 Pixel: %3</translation>
    </message>
    <message>
        <source>automatic: %1 m, assumed</source>
        <translation>automatisch: %1 m, angenommen</translation>
    </message>
    <message>
        <source>Open a photograph</source>
        <translation>Fotografie öffnen</translation>
    </message>
    <message>
        <source>Reading the photograph</source>
        <translation>Die Fotografie wird gelesen</translation>
    </message>
    <message>
        <source>Horizontal field of view. Automatic reads it from the photograph, otherwise assumes 60°. If it is wrong, turned objects look too deep or too flat.</source>
        <translation>Horizontaler Bildwinkel. Automatisch: aus der Fotografie, sonst werden 60° angenommen. Ist er falsch, sehen gedrehte Gegenstände zu tief oder zu flach aus.</translation>
    </message>
    <message>
        <source>Meaning of the numbers in the depth map</source>
        <translation>Bedeutung der Zahlen in der Tiefenkarte</translation>
    </message>
    <message>
        <source>Exchange near and far</source>
        <translation>Nah und fern vertauschen</translation>
    </message>
    <message>
        <source>For maps whose bright parts are far where they should be near, or the other way round: reads the numbers as inverse depth instead of depth, or back</source>
        <translation>Für Karten, deren helle Teile fern statt nah sind oder umgekehrt: liest die Zahlen als inverse Tiefe statt als Tiefe, oder zurück</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Open with objects that were marked in another program</source>
        <translation>Mit Objekten öffnen, die in einem anderen Programm markiert wurden</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>From the right and above</source>
        <translation>Von rechts oben</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>As the camera saw it</source>
        <translation>Wie die Kamera es sah</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>From above, with the camera below</source>
        <translation>Von oben, mit der Kamera unten</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>From the right, with the camera at the left</source>
        <translation>Von rechts, mit der Kamera links</translation>
    </message>
    <message>
        <source>How deep the scene is</source>
        <translation>Wie tief die Szene ist</translation>
    </message>
    <message>
        <source>Choose a photograph.</source>
        <translation>Wählen Sie eine Fotografie.</translation>
    </message>
    <message>
        <source>depth map, %1 × %2 pixels</source>
        <translation>Tiefenkarte, %1 × %2 Pixel</translation>
    </message>
    <message>
        <source>Depth from %1 to %2 m, half of it nearer than %3 m.</source>
        <translation>Tiefe von %1 bis %2 m, zur Hälfte näher als %3 m.</translation>
    </message>
    <message>
        <source>Nothing states the unit, so the middle is assumed to be 1 m away.</source>
        <translation>Die Einheit steht nirgends, daher wird die Mitte in 1 m Entfernung angenommen.</translation>
    </message>
    <message>
        <source>The unit or the kind is probably wrong.</source>
        <translation>Einheit oder Art sind wahrscheinlich falsch.</translation>
    </message>
    <message>
        <source>inside the photograph</source>
        <translation>in der Fotografie</translation>
    </message>
    <message>
        <source>automatic: %1 m</source>
        <translation>automatisch: %1 m</translation>
    </message>
    <message>
        <source>automatic: %1°</source>
        <translation>automatisch: %1°</translation>
    </message>
    <message>
        <source>automatic: 60°, assumed</source>
        <translation>automatisch: 60°, angenommen</translation>
    </message>
    <message>
        <source>No depth found. Objects can be selected by their colour. To change materials, add a depth map: choose its file as &quot;Depth&quot;, or open a photograph that has depth, such as the original of a phone&apos;s portrait photo.</source>
        <translation>Keine Tiefe gefunden. Objekte lassen sich nach ihrer Farbe auswählen. Um Materialien zu ändern, ist eine Tiefenkarte nötig: Wählen Sie ihre Datei als „Tiefe“, oder öffnen Sie eine Fotografie mit Tiefe, etwa das Original eines Handy-Porträtfotos.</translation>
    </message>
</context>
<context>
    <name>ui::NoticeButton</name>
    <message>
        <source>Notices</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>What was found in the files and assumed by the analysis</source>
        <translation>Was in den Dateien gefunden und von der Analyse angenommen wurde</translation>
    </message>
    <message>
        <source>1 new notice</source>
        <translation>1 neuer Hinweis</translation>
    </message>
    <message>
        <source>%1 new notices</source>
        <translation>%1 neue Hinweise</translation>
    </message>
    <message>
        <source>1 notice</source>
        <translation>1 Hinweis</translation>
    </message>
    <message>
        <source>%1 notices</source>
        <translation>%1 Hinweise</translation>
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
    <name>ui::PolygonTool</name>
    <message>
        <source>Click the next corner. A double click or Enter closes the outline, Backspace takes a corner back, Escape drops it.</source>
        <translation>Klicken Sie auf die nächste Ecke. Doppelklick oder Eingabe schließt den Umriss, Rücktaste nimmt eine Ecke zurück, Escape verwirft ihn.</translation>
    </message>
    <message>
        <source>Click the corners of the object, one after the other.</source>
        <translation>Klicken Sie nacheinander auf die Ecken des Objekts.</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Vieleck</translation>
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
    <name>ui::SceneChange</name>
    <message>
        <source>Please wait until the last change of the segments is made.</source>
        <translation>Bitte warten Sie, bis die letzte Änderung der Segmente fertig ist.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Patina</source>
        <translation>Patina</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
</context>
<context>
    <name>ui::SegmentActions</name>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Vereinen</translation>
    </message>
    <message>
        <source>Split into pieces</source>
        <translation>In Stücke teilen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select pixels</source>
        <translation>Pixel auswählen</translation>
    </message>
    <message>
        <source>Select all edited</source>
        <translation>Alle bearbeiteten auswählen</translation>
    </message>
    <message>
        <source>Glossy</source>
        <translation>Glänzend</translation>
    </message>
    <message>
        <source>Treat the segment&apos;s colours as reflections (Space)</source>
        <translation>Die Farben des Segments als Spiegelungen verstehen (Leertaste)</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Import mask or label map…</source>
        <translation>Maske oder Segmentkarte importieren…</translation>
    </message>
    <message>
        <source>Export mask…</source>
        <translation>Maske exportieren…</translation>
    </message>
    <message>
        <source>Give the segment another name (F2)</source>
        <translation>Dem Segment einen anderen Namen geben (F2)</translation>
    </message>
    <message>
        <source>Delete the segments; their pixels belong to none (Del)</source>
        <translation>Die Segmente löschen; ihre Pixel gehören dann zu keinem (Entf)</translation>
    </message>
    <message>
        <source>Select all segments that have a new material</source>
        <translation>Alle Segmente auswählen, die ein neues Material haben</translation>
    </message>
    <message>
        <source>Select the segments&apos; pixels in the picture</source>
        <translation>Die Pixel der Segmente im Bild auswählen</translation>
    </message>
    <message>
        <source>Make segments from a black-and-white mask or a label map. Files can also be dropped on the list.</source>
        <translation>Aus einer Schwarzweißmaske oder einer Segmentkarte Segmente machen. Dateien lassen sich auch auf die Liste ziehen.</translation>
    </message>
    <message>
        <source>Save the segments&apos; pixels as a picture: white on black</source>
        <translation>Die Pixel der Segmente als Bild speichern: weiß auf schwarz</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Show the new material again</source>
        <translation>Das neue Material wieder zeigen</translation>
    </message>
    <message>
        <source>Show the segment as photographed, and keep its material</source>
        <translation>Das Segment zeigen, wie es fotografiert wurde, und sein Material behalten</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Let the segment&apos;s pixels change again</source>
        <translation>Änderungen an den Pixeln des Segments wieder erlauben</translation>
    </message>
    <message>
        <source>Protect the segment&apos;s pixels from every change</source>
        <translation>Die Pixel des Segments vor jeder Änderung schützen</translation>
    </message>
    <message>
        <source>Make a segment of the selected pixels, with everything else as in &quot;%1&quot; (Ctrl+J)</source>
        <translation>Aus den ausgewählten Pixeln ein Segment machen, alles andere wie in „%1“ (Strg+J)</translation>
    </message>
    <message>
        <source>Segments share no pixels: select in the picture the pixels that the copy shall have, and here one segment.</source>
        <translation>Segmente teilen keine Pixel: Wählen Sie im Bild die Pixel aus, die die Kopie haben soll, und hier ein Segment.</translation>
    </message>
    <message>
        <source>Make one segment of all, with the name and material of &quot;%1&quot; (Ctrl+M)</source>
        <translation>Aus allen ein Segment machen, mit Namen und Material von „%1“ (Strg+M)</translation>
    </message>
    <message>
        <source>Select two or more segments; the uppermost keeps its name and material.</source>
        <translation>Wählen Sie zwei oder mehr Segmente aus; das oberste behält Namen und Material.</translation>
    </message>
    <message>
        <source>Make a segment of each piece that does not touch the others</source>
        <translation>Aus jedem Stück, das die anderen nicht berührt, ein Segment machen</translation>
    </message>
    <message>
        <source>The segment is in one piece, or locked.</source>
        <translation>Das Segment besteht aus einem Stück oder ist gesperrt.</translation>
    </message>
    <message>
        <source>Select one segment that is in several pieces.</source>
        <translation>Wählen Sie ein Segment aus, das aus mehreren Stücken besteht.</translation>
    </message>
    <message>
        <source>%1 segments</source>
        <translation>%1 Segmente</translation>
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
        <source>Show %1</source>
        <translation>%1 einblenden</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>%1 sperren</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>%1 entsperren</translation>
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
        <source>%1 segments are one now: %2</source>
        <translation>%1 Segmente sind nun eines: %2</translation>
    </message>
    <message>
        <source>Merge segments</source>
        <translation>Segmente vereinen</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>Duplicated %1</source>
        <translation>%1 dupliziert</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>%1 teilen</translation>
    </message>
    <message>
        <source>%1 is in %2 segments now</source>
        <translation>%1 besteht nun aus %2 Segmenten</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Please wait until the last file has been read or written.</source>
        <translation>Bitte warten Sie, bis die letzte Datei gelesen oder geschrieben ist.</translation>
    </message>
    <message>
        <source>Import segments</source>
        <translation>Segmente importieren</translation>
    </message>
    <message>
        <source>Imported %1</source>
        <translation>%1 importiert</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 exportiert</translation>
    </message>
    <message>
        <source>Import mask or label map</source>
        <translation>Maske oder Segmentkarte importieren</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.tiff *.exr *.pfm *.pgm *.hdr);;All files (*)</source>
        <translation>Bilder (*.png *.tif *.tiff *.exr *.pfm *.pgm *.hdr);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export mask</source>
        <translation>Maske exportieren</translation>
    </message>
    <message>
        <source>PNG (*.png);;TIFF (*.tif);;OpenEXR (*.exr)</source>
        <translation>PNG (*.png);;TIFF (*.tif);;OpenEXR (*.exr)</translation>
    </message>
</context>
<context>
    <name>ui::SegmentModel</name>
    <message>
        <source>&lt;%1 %</source>
        <translation>&lt;%1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Segment %1, label %2</source>
        <translation>Segment %1, Nummer %2</translation>
    </message>
    <message>
        <source>Treat the segment&apos;s colours as reflections</source>
        <translation>Die Farben des Segments als Spiegelungen verstehen</translation>
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
        <source>%1 of %2 pixels</source>
        <translation>%1 von %2 Pixeln</translation>
    </message>
    <message>
        <source>Its new material is shown. Click to hide it.</source>
        <translation>Sein neues Material wird gezeigt. Klicken blendet es aus.</translation>
    </message>
    <message>
        <source>It is shown as photographed; its material is kept. Click to show it.</source>
        <translation>Es wird gezeigt, wie es fotografiert wurde; sein Material bleibt erhalten. Klicken blendet es ein.</translation>
    </message>
    <message>
        <source>Its pixels cannot be changed. Click to unlock it.</source>
        <translation>Seine Pixel können nicht geändert werden. Klicken entsperrt es.</translation>
    </message>
    <message>
        <source>Click to protect its pixels from changes.</source>
        <translation>Klicken schützt seine Pixel vor Änderungen.</translation>
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
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Sort by name</source>
        <translation>Nach Namen ordnen</translation>
    </message>
    <message>
        <source>Glossy segments show reflections, from which the light is recovered.</source>
        <translation>Glänzende Segmente zeigen Spiegelungen, aus denen das Licht gewonnen wird.</translation>
    </message>
    <message>
        <source>Segments with a new material</source>
        <translation>Segmente mit einem neuen Material</translation>
    </message>
    <message>
        <source>Share of the picture</source>
        <translation>Anteil am Bild</translation>
    </message>
    <message>
        <source>Whether the new material is shown</source>
        <translation>Ob das neue Material gezeigt wird</translation>
    </message>
    <message>
        <source>Whether the pixels are protected</source>
        <translation>Ob die Pixel geschützt sind</translation>
    </message>
</context>
<context>
    <name>ui::SegmentsPanel</name>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Open a photograph: File &gt; Open, or drop it on the window.</source>
        <translation>Öffnen Sie ein Foto: Datei &gt; Öffnen, oder ziehen Sie es auf das Fenster.</translation>
    </message>
    <message>
        <source>Click an object in the picture with Smart select, then press Enter.</source>
        <translation>Klicken Sie im Bild mit der intelligenten Auswahl auf ein Objekt und drücken Sie dann die Eingabetaste.</translation>
    </message>
    <message>
        <source>Tick Glossy for an object with reflections: the light is recovered from them.</source>
        <translation>Markieren Sie ein Objekt mit Spiegelungen als glänzend: aus ihnen wird das Licht gewonnen.</translation>
    </message>
</context>
<context>
    <name>ui::SelectionSession</name>
    <message>
        <source>Clear selection</source>
        <translation>Auswahl aufheben</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Select something in the picture first.</source>
        <translation>Wählen Sie zuerst etwas im Bild aus.</translation>
    </message>
    <message>
        <source>object %1</source>
        <translation>Objekt %1</translation>
    </message>
    <message>
        <source>New segment</source>
        <translation>Neues Segment</translation>
    </message>
    <message>
        <source>Add to %1</source>
        <translation>Zu %1 hinzufügen</translation>
    </message>
    <message>
        <source>Take from %1</source>
        <translation>Von %1 wegnehmen</translation>
    </message>
    <message>
        <source>Intersect with %1</source>
        <translation>Mit %1 schneiden</translation>
    </message>
    <message>
        <source>Find objects</source>
        <translation>Objekte finden</translation>
    </message>
    <message>
        <source>object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Objects found: %1</source>
        <translation>Gefundene Objekte: %1</translation>
    </message>
    <message>
        <source>Refined: %1 pixels changed</source>
        <translation>Verfeinert: %1 Pixel geändert</translation>
    </message>
    <message>
        <source>Refined: the outline already follows the photograph</source>
        <translation>Verfeinert: Der Umriss folgt der Fotografie schon</translation>
    </message>
</context>
<context>
    <name>ui::SmartSelectTool</name>
    <message>
        <source>Finding regions… A click waits until they are known.</source>
        <translation>Bereiche werden gesucht … Ein Klick wartet, bis sie bekannt sind.</translation>
    </message>
    <message>
        <source>Click an object to select it; drag over several of its parts.</source>
        <translation>Klicken Sie auf ein Objekt, um es auszuwählen; ziehen Sie über mehrere seiner Teile.</translation>
    </message>
    <message>
        <source>Click adds, Alt-click takes away. Press Enter to make a segment of it.</source>
        <translation>Klick fügt hinzu, Alt-Klick nimmt weg. Die Eingabetaste macht ein Segment daraus.</translation>
    </message>
    <message>
        <source>Click inside the picture.</source>
        <translation>Klicken Sie in das Bild.</translation>
    </message>
    <message>
        <source>Take from selection</source>
        <translation>Von der Auswahl wegnehmen</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
</context>
<context>
    <name>ui::StartPage</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Open photo or project…</source>
        <translation>Foto oder Projekt öffnen…</translation>
    </message>
    <message>
        <source>Photographs with depth, photographs with a depth map beside them, and projects</source>
        <translation>Fotografien mit Tiefe, Fotografien mit einer Tiefenkarte daneben, und Projekte</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Recent projects and photographs</source>
        <translation>Zuletzt geöffnete Projekte und Fotografien</translation>
    </message>
    <message>
        <source>Remove from list</source>
        <translation>Aus der Liste entfernen</translation>
    </message>
    <message>
        <source>Forget the selected file; the file itself stays (Delete)</source>
        <translation>Die ausgewählte Datei vergessen; die Datei selbst bleibt (Entf)</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Edited examples</source>
        <translation>Bearbeitete Beispiele</translation>
    </message>
    <message>
        <source>Change what things in a photograph are made of</source>
        <translation>Ändern, woraus die Dinge in einer Fotografie bestehen</translation>
    </message>
    <message>
        <source>or drop a file here</source>
        <translation>oder eine Datei hierher ziehen</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>%1 is no longer in its folder: it was moved, renamed or deleted.</source>
        <translation>%1 liegt nicht mehr in ihrem Ordner: Sie wurde verschoben, umbenannt oder gelöscht.</translation>
    </message>
    <message>
        <source>The folder of %1 cannot be found: it was moved, or its disk is not connected.</source>
        <translation>Der Ordner von %1 ist nicht zu finden: Er wurde verschoben, oder sein Laufwerk ist nicht angeschlossen.</translation>
    </message>
</context>
<context>
    <name>ui::ToolBox</name>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>Select the whole picture</source>
        <translation>Das ganze Bild auswählen</translation>
    </message>
    <message>
        <source>&amp;Clear selection</source>
        <translation>Auswahl auf&amp;heben</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Nichts auswählen</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>&amp;Umkehren</translation>
    </message>
    <message>
        <source>Select what is not selected</source>
        <translation>Auswählen, was nicht ausgewählt ist</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>&amp;Erweitern</translation>
    </message>
    <message>
        <source>Add a border of the width in the bar above the picture</source>
        <translation>Einen Rand hinzufügen, so breit, wie die Leiste über dem Bild sagt</translation>
    </message>
    <message>
        <source>S&amp;hrink</source>
        <translation>&amp;Verkleinern</translation>
    </message>
    <message>
        <source>Take a border of the width in the bar above the picture away</source>
        <translation>Einen Rand wegnehmen, so breit, wie die Leiste über dem Bild sagt</translation>
    </message>
    <message>
        <source>&amp;Fill holes</source>
        <translation>&amp;Löcher füllen</translation>
    </message>
    <message>
        <source>Add the areas that the selection encloses</source>
        <translation>Die Flächen hinzufügen, die die Auswahl umschließt</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Glätten</translation>
    </message>
    <message>
        <source>Round the outline off and drop specks, as wide as the bar above the picture says</source>
        <translation>Umriss abrunden und Krümel weglassen, so breit, wie die Leiste über dem Bild sagt</translation>
    </message>
    <message>
        <source>&amp;Refine whole edge</source>
        <translation>Ganze &amp;Kante verfeinern</translation>
    </message>
    <message>
        <source>Find the outline again in the photograph, at most the width in the bar above the picture away</source>
        <translation>Den Umriss im Foto neu suchen, höchstens so weit entfernt, wie die Leiste über dem Bild sagt</translation>
    </message>
    <message>
        <source>&amp;New segment</source>
        <translation>&amp;Neues Segment</translation>
    </message>
    <message>
        <source>Make a segment of what is selected (Enter)</source>
        <translation>Aus der Auswahl ein Segment machen (Eingabe)</translation>
    </message>
    <message>
        <source>Add &amp;to segment</source>
        <translation>&amp;Zum Segment hinzufügen</translation>
    </message>
    <message>
        <source>Add what is selected to the current segment</source>
        <translation>Die Auswahl dem aktuellen Segment hinzufügen</translation>
    </message>
    <message>
        <source>Ta&amp;ke from segment</source>
        <translation>Vom Segment &amp;wegnehmen</translation>
    </message>
    <message>
        <source>Take what is selected away from the current segment</source>
        <translation>Die Auswahl vom aktuellen Segment wegnehmen</translation>
    </message>
    <message>
        <source>Inter&amp;sect with segment</source>
        <translation>Mit Segment &amp;schneiden</translation>
    </message>
    <message>
        <source>Leave only what is selected of the current segment</source>
        <translation>Vom aktuellen Segment nur lassen, was ausgewählt ist</translation>
    </message>
    <message>
        <source>Find &amp;objects</source>
        <translation>&amp;Objekte finden</translation>
    </message>
    <message>
        <source>Make a segment of each object that stands on a table, floor or wall</source>
        <translation>Aus jedem Objekt auf einem Tisch, Boden oder an einer Wand ein Segment machen</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>The shape replaces the selection</source>
        <translation>Die Form ersetzt die Auswahl</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>The shape is added to the selection (Shift)</source>
        <translation>Die Form kommt zur Auswahl hinzu (Umschalt)</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>The shape is taken from the selection (Alt)</source>
        <translation>Die Form wird von der Auswahl weggenommen (Alt)</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>What the shape and the selection share stays (Shift+Alt)</source>
        <translation>Was Form und Auswahl gemeinsam haben, bleibt (Umschalt+Alt)</translation>
    </message>
    <message>
        <source>Selection tools</source>
        <translation>Auswahlwerkzeuge</translation>
    </message>
    <message>
        <source>Tool options</source>
        <translation>Werkzeugoptionen</translation>
    </message>
    <message>
        <source>Width for growing, shrinking and smoothing</source>
        <translation>Breite zum Erweitern, Verkleinern und Glätten</translation>
    </message>
    <message>
        <source>By how many pixels Grow, Shrink, Smooth and Refine whole edge change the outline</source>
        <translation>Um wie viele Bildpunkte Erweitern, Verkleinern, Glätten und Ganze Kante verfeinern den Umriss ändern</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Open a photograph or a project to begin.</source>
        <translation>Öffnen Sie ein Foto oder ein Projekt, um zu beginnen.</translation>
    </message>
    <message>
        <source>Paint where the parameter is to vary; Shift erases. A tool on the left ends painting.</source>
        <translation>Malen Sie, wo sich der Parameter ändern soll; Umschalt radiert. Ein Werkzeug links beendet das Malen.</translation>
    </message>
    <message>
        <source>Hint and selection</source>
        <translation>Hinweis und Auswahl</translation>
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
