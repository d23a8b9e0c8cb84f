<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="hu_HU" sourcelanguage="en_GB">
    <context>
        <name>prizma::ViewportNotice</name>
        <message>
            <source>Prizma draws with OpenCL. To let it use this computer's processor:
sudo apt install pocl-opencl-icd</source>
            <translation>A Prizma OpenCL-lel rajzol. Hogy e gép processzorát használhassa:
sudo apt install pocl-opencl-icd</translation>
        </message>
        <message>
            <source>%1…</source>
            <translation>%1…</translation>
        </message>
        <message>
            <source>The picture could not be drawn</source>
            <translation>A kép nem készült el</translation>
        </message>
        <message>
            <source>No OpenCL device to draw with</source>
            <translation>Nincs OpenCL-eszköz a rajzoláshoz</translation>
        </message>
        <message>
            <source>Drawing the first picture…</source>
            <translation>Az első kép készül…</translation>
        </message>
        <message>
            <source>Looking for an OpenCL device…</source>
            <translation>OpenCL-eszköz keresése…</translation>
        </message>
    </context>
    <context>
        <name>main</name>
        <message>
            <source>Edits 3D scenes in a view that is ray traced live.</source>
            <translation>3D jelenetek szerkesztése valós idejű sugárkövetéssel.</translation>
        </message>
        <message>
            <source>Renders on this OpenCL device (see prizma-render devices).</source>
            <translation>Ezen az OpenCL-eszközön számol (lásd: prizma-render devices).</translation>
        </message>
        <message>
            <source>ID</source>
            <translation>ID</translation>
        </message>
        <message>
            <source>FILE</source>
            <translation>FÁJL</translation>
        </message>
        <message>
            <source>Projects to open and models to import.</source>
            <translation>Megnyitandó projektek és importálandó modellek.</translation>
        </message>
    </context>
    <context>
        <name>prizma</name>
        <message numerus="yes">
            <source>%n object(s)</source>
            <translation>
                <numerusform>%n tárgy</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n light(s)</source>
            <translation>
                <numerusform>%n fény</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n material(s)</source>
            <translation>
                <numerusform>%n anyag</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n thing(s)</source>
            <translation>
                <numerusform>%n dolog</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n group(s)</source>
            <translation>
                <numerusform>%n csoport</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>prizma::AnimationExportDialog</name>
        <message>
            <source>Render frames &amp;again that are there already</source>
            <translation>A már meglévő képkockák újra&amp;számolása</translation>
        </message>
        <message>
            <source>&amp;Keep the pictures that the video is made of</source>
            <translation>A videó képei is &amp;maradjanak meg</translation>
        </message>
        <message>
            <source>Export Animation</source>
            <translation>Animáció mentése</translation>
        </message>
        <message>
            <source>&amp;Format:</source>
            <translation>&amp;Formátum:</translation>
        </message>
        <message>
            <source>F&amp;rames:</source>
            <translation>&amp;Képkockák:</translation>
        </message>
        <message>
            <source>to</source>
            <translation>–</translation>
        </message>
        <message>
            <source>Si&amp;ze:</source>
            <translation>Mé&amp;ret:</translation>
        </message>
        <message>
            <source>&amp;Samples a pixel:</source>
            <translation>Minták képponton&amp;ként:</translation>
        </message>
        <message>
            <source>&amp;Output:</source>
            <translation>&amp;Hová:</translation>
        </message>
        <message>
            <source>&amp;Export</source>
            <translation>M&amp;entés</translation>
        </message>
        <message>
            <source>PNG pictures</source>
            <translation>PNG képek</translation>
        </message>
        <message>
            <source>OpenEXR pictures (linear, 32 bits)</source>
            <translation>OpenEXR képek (lineáris, 32 bites)</translation>
        </message>
        <message>
            <source>MP4 video (H.264)</source>
            <translation>MP4 videó (H.264)</translation>
        </message>
        <message>
            <source>WebM video (VP9)</source>
            <translation>WebM videó (VP9)</translation>
        </message>
        <message>
            <source>Needs the program ffmpeg (on Debian: sudo apt install ffmpeg)</source>
            <translation>Az ffmpeg program kell hozzá (Debianon: sudo apt install ffmpeg)</translation>
        </message>
        <message>
            <source>A run of # stands for the number of the frame</source>
            <translation>A # jelek helyére a képkocka száma kerül</translation>
        </message>
        <message>
            <source>Choose the folder and the name</source>
            <translation>A mappa és a név kiválasztása</translation>
        </message>
        <message>
            <source>Export the Animation</source>
            <translation>Animáció mentése</translation>
        </message>
        <message>
            <source>This cannot be exported: %1.</source>
            <translation>Ez nem menthető: %1.</translation>
        </message>
        <message>
            <source>%1 of %2 frames are there already and stay as they are.</source>
            <translation>%2 képkockából %1 már megvan, és úgy marad.</translation>
        </message>
        <message>
            <source>One frame will be rendered.</source>
            <translation>Egy képkocka készül.</translation>
        </message>
        <message numerus="yes">
            <source>%n frames will be rendered.</source>
            <translation>
                <numerusform>%n képkocka készül.</numerusform>
            </translation>
        </message>
        <message>
            <source>PNG pictures of 16 bits a channel</source>
            <translation>PNG-képek, csatornánként 16 bit</translation>
        </message>
    </context>
    <context>
        <name>prizma::AnimationExporter</name>
        <message>
            <source>Exporting %1…</source>
            <translation>%1 mentése…</translation>
        </message>
        <message>
            <source>The export was cancelled. The frames that are done stay: to go on, export again.</source>
            <translation>A mentés megszakadt. A kész képkockák megmaradnak: a folytatáshoz indítsd újra a mentést.</translation>
        </message>
        <message>
            <source>Exported one frame.</source>
            <translation>Egy képkocka elmentve.</translation>
        </message>
        <message numerus="yes">
            <source>Exported %n frames.</source>
            <translation>
                <numerusform>%n képkocka elmentve.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n of them had been rendered before.</source>
            <translation>
                <numerusform>Közülük %n már korábban elkészült.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>prizma::BadgeDelegate</name>
        <message>
            <source>Dynamic</source>
            <translation>Dinamikus</translation>
        </message>
        <message>
            <source>Static</source>
            <translation>Statikus</translation>
        </message>
    </context>
    <context>
        <name>prizma::ClipList</name>
        <message>
            <source>%1: %2 s%3</source>
            <translation>%1: %2 s%3</translation>
        </message>
        <message>
            <source>, loops</source>
            <translation>, ismétlődik</translation>
        </message>
        <message>
            <source>No clips. Import a model that has animations, or select it.</source>
            <translation>Nincs mozgás. Importálj vagy jelölj ki egy modellt, amelynek van.</translation>
        </message>
        <message>
            <source>Clips</source>
            <translation>Mozgások</translation>
        </message>
        <message>
            <source>Bind pose</source>
            <translation>Alapállás</translation>
        </message>
        <message>
            <source>Clips of %1</source>
            <translation>%1 mozgásai</translation>
        </message>
        <message>
            <source>Frames a second</source>
            <translation>Képkocka másodpercenként</translation>
        </message>
        <message>
            <source>Frames</source>
            <translation>Kocka</translation>
        </message>
        <message>
            <source>1/s</source>
            <translation>1/s</translation>
        </message>
    </context>
    <context>
        <name>prizma::ColorEditor</name>
        <message>
            <source>Choose a colour</source>
            <translation>Szín választása</translation>
        </message>
        <message>
            <source>Red (linear)</source>
            <translation>Vörös (lineáris)</translation>
        </message>
        <message>
            <source>Green (linear)</source>
            <translation>Zöld (lineáris)</translation>
        </message>
        <message>
            <source>Blue (linear)</source>
            <translation>Kék (lineáris)</translation>
        </message>
    </context>
    <context>
        <name>prizma::DeviceDialog</name>
        <message>
            <source>&amp;Use This Device</source>
            <translation>Ezt &amp;használja</translation>
        </message>
        <message>
            <source>&amp;Refresh</source>
            <translation>&amp;Frissítés</translation>
        </message>
        <message>
            <source>OpenCL Devices</source>
            <translation>OpenCL-eszközök</translation>
        </message>
        <message>
            <source>Looking for devices…</source>
            <translation>Eszközök keresése…</translation>
        </message>
        <message>
            <source>There is no OpenCL device.</source>
            <translation>Nincs OpenCL-eszköz.</translation>
        </message>
        <message>
            <source>One device found.</source>
            <translation>Egy eszköz van.</translation>
        </message>
        <message numerus="yes">
            <source>%n devices found.</source>
            <translation>
                <numerusform>%n eszköz van.</numerusform>
            </translation>
        </message>
        <message>
            <source>This device is not available, or has no compiler.</source>
            <translation>Ez az eszköz nem elérhető, vagy nincs fordítója.</translation>
        </message>
        <message>
            <source>This device is in use.</source>
            <translation>Ez az eszköz van használatban.</translation>
        </message>
        <message>
            <source>Changing to %1…</source>
            <translation>Átváltás: %1…</translation>
        </message>
        <message>
            <source>%1 draws the picture now.</source>
            <translation>Mostantól ez rajzol: %1.</translation>
        </message>
    </context>
    <context>
        <name>prizma::DeviceTable</name>
        <message>
            <source>Device</source>
            <translation>Eszköz</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>Fajta</translation>
        </message>
        <message>
            <source>Compute units</source>
            <translation>Számolóegységek</translation>
        </message>
        <message>
            <source>Clock</source>
            <translation>Órajel</translation>
        </message>
        <message>
            <source>Memory</source>
            <translation>Memória</translation>
        </message>
        <message>
            <source>Double precision</source>
            <translation>Dupla pontosság</translation>
        </message>
        <message>
            <source>OpenCL</source>
            <translation>OpenCL</translation>
        </message>
        <message>
            <source>State</source>
            <translation>Állapot</translation>
        </message>
        <message>
            <source>OpenCL devices</source>
            <translation>OpenCL-eszközök</translation>
        </message>
        <message>
            <source>In use</source>
            <translation>Használatban</translation>
        </message>
        <message>
            <source>Usable</source>
            <translation>Használható</translation>
        </message>
        <message>
            <source>Not usable</source>
            <translation>Nem használható</translation>
        </message>
        <message>
            <source>%1 MHz</source>
            <translation>%1 MHz</translation>
        </message>
    </context>
    <context>
        <name>prizma::Document</name>
        <message>
            <source>Rename %1</source>
            <translation>%1 átnevezése</translation>
        </message>
        <message>
            <source>Show %1</source>
            <translation>%1 megjelenítése</translation>
        </message>
        <message>
            <source>Hide %1</source>
            <translation>%1 elrejtése</translation>
        </message>
        <message>
            <source>Switch on %1</source>
            <translation>%1 bekapcsolása</translation>
        </message>
        <message>
            <source>Switch off %1</source>
            <translation>%1 kikapcsolása</translation>
        </message>
        <message>
            <source>Change %1 of %2</source>
            <translation>%2: %1 módosítása</translation>
        </message>
        <message>
            <source>Untitled</source>
            <translation>Névtelen</translation>
        </message>
        <message>
            <source>Delete %1</source>
            <translation>%1 törlése</translation>
        </message>
        <message>
            <source>Duplicate %1</source>
            <translation>%1 kettőzése</translation>
        </message>
        <message>
            <source>Add %1</source>
            <translation>%1 hozzáadása</translation>
        </message>
        <message>
            <source>Add light</source>
            <translation>Fény hozzáadása</translation>
        </message>
        <message>
            <source>Add material</source>
            <translation>Anyag hozzáadása</translation>
        </message>
        <message>
            <source>Assign %1</source>
            <translation>%1 hozzárendelése</translation>
        </message>
        <message>
            <source>Import model</source>
            <translation>Modell importálása</translation>
        </message>
        <message>
            <source>Change clip of %1</source>
            <translation>%1 mozgásának módosítása</translation>
        </message>
        <message>
            <source>Fit timeline to %1</source>
            <translation>Idővonal igazítása: %1</translation>
        </message>
        <message>
            <source>Import models</source>
            <translation>Modellek importálása</translation>
        </message>
        <message>
            <source>Import animation</source>
            <translation>Animáció importálása</translation>
        </message>
    </context>
    <context>
        <name>prizma::EditActions</name>
        <message>
            <source>&amp;Delete</source>
            <translation>&amp;Törlés</translation>
        </message>
        <message>
            <source>D&amp;uplicate</source>
            <translation>&amp;Kettőzés</translation>
        </message>
        <message>
            <source>Remove what is selected from the scene</source>
            <translation>A kijelöltek eltávolítása a jelenetből</translation>
        </message>
        <message>
            <source>Put a copy beside what is selected</source>
            <translation>Másolat a kijelöltek mellé</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>&amp;Visszavonás:</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>&amp;Újra:</translation>
        </message>
        <message>
            <source>Select &amp;All</source>
            <translation>&amp;Mindent kijelöl</translation>
        </message>
        <message>
            <source>Select all objects and lights</source>
            <translation>Minden tárgy és fény kijelölése</translation>
        </message>
        <message>
            <source>Select &amp;None</source>
            <translation>Kijelölés meg&amp;szüntetése</translation>
        </message>
        <message>
            <source>&amp;Preferences…</source>
            <translation>&amp;Beállítások…</translation>
        </message>
        <message>
            <source>&amp;Primitive</source>
            <translation>&amp;Alaptest</translation>
        </message>
        <message>
            <source>&amp;Light</source>
            <translation>&amp;Fény</translation>
        </message>
        <message>
            <source>&amp;Material</source>
            <translation>An&amp;yag</translation>
        </message>
    </context>
    <context>
        <name>prizma::ExportActions</name>
        <message>
            <source>Export Ani&amp;mation…</source>
            <translation>&amp;Animáció mentése…</translation>
        </message>
        <message>
            <source>Render the frames of the timeline into pictures or a video</source>
            <translation>Az idővonal képkockái képekbe vagy videóba</translation>
        </message>
        <message>
            <source>&amp;Export Image…</source>
            <translation>&amp;Kép mentése…</translation>
        </message>
        <message>
            <source>Save the picture that is in the view</source>
            <translation>A látható kép mentése</translation>
        </message>
    </context>
    <context>
        <name>prizma::ExportProgressDialog</name>
        <message>
            <source>Exporting %1</source>
            <translation>%1 mentése</translation>
        </message>
        <message>
            <source>&amp;Hide</source>
            <translation>El&amp;rejtés</translation>
        </message>
        <message>
            <source>The export goes on; its menu command shows this again</source>
            <translation>A mentés folytatódik; a menüparancsa ismét megmutatja ezt</translation>
        </message>
        <message>
            <source>Making the video</source>
            <translation>Készül a videó</translation>
        </message>
        <message>
            <source>Frame %1 of %2</source>
            <translation>%1. képkocka a(z) %2 közül</translation>
        </message>
        <message>
            <source>Starting…</source>
            <translation>Indul…</translation>
        </message>
        <message>
            <source>About a second left</source>
            <translation>Még körülbelül egy másodperc</translation>
        </message>
        <message numerus="yes">
            <source>About %n seconds left</source>
            <translation>
                <numerusform>Még körülbelül %n másodperc</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>About %n minutes left</source>
            <translation>
                <numerusform>Még körülbelül %n perc</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>prizma::FileActions</name>
        <message>
            <source>3D models (%1)</source>
            <translation>3D modellek (%1)</translation>
        </message>
        <message>
            <source>&amp;New</source>
            <translation>&amp;Új</translation>
        </message>
        <message>
            <source>Start with an empty scene</source>
            <translation>Új, üres jelenet</translation>
        </message>
        <message>
            <source>&amp;Open…</source>
            <translation>&amp;Megnyitás…</translation>
        </message>
        <message>
            <source>Open a project file</source>
            <translation>Projekt megnyitása</translation>
        </message>
        <message>
            <source>Open &amp;Recent</source>
            <translation>&amp;Legutóbbiak</translation>
        </message>
        <message>
            <source>&amp;Save</source>
            <translation>M&amp;entés</translation>
        </message>
        <message>
            <source>Save &amp;As…</source>
            <translation>Menté&amp;s másként…</translation>
        </message>
        <message>
            <source>&amp;Import Model…</source>
            <translation>Modell &amp;importálása…</translation>
        </message>
        <message>
            <source>Add the contents of model files to the scene</source>
            <translation>Modellek hozzáadása a jelenethez</translation>
        </message>
        <message>
            <source>&amp;Quit</source>
            <translation>Ki&amp;lépés</translation>
        </message>
        <message>
            <source>Open a Project</source>
            <translation>Projekt megnyitása</translation>
        </message>
        <message>
            <source>Prizma projects (*.prizma)</source>
            <translation>Prizma projektek (*.prizma)</translation>
        </message>
        <message>
            <source>All files (*)</source>
            <translation>Minden fájl (*)</translation>
        </message>
        <message>
            <source>Save the Project</source>
            <translation>Projekt mentése</translation>
        </message>
        <message>
            <source>The Project Was Not Saved</source>
            <translation>A projekt nincs elmentve</translation>
        </message>
        <message>
            <source>Import Models</source>
            <translation>Modellek importálása</translation>
        </message>
        <message>
            <source>Import A&amp;nimation…</source>
            <translation>A&amp;nimáció importálása…</translation>
        </message>
        <message>
            <source>Give the selected object the clips of animation files</source>
            <translation>A kijelölt tárgy megkapja animációs fájlok mozgásait</translation>
        </message>
        <message>
            <source>Animations (%1)</source>
            <translation>Animációk (%1)</translation>
        </message>
        <message>
            <source>Import Animations</source>
            <translation>Animációk importálása</translation>
        </message>
        <message>
            <source>No Object Can Be Animated</source>
            <translation>Nincs mozgatható tárgy</translation>
        </message>
        <message>
            <source>Select the object that the animation is for. It must have bones.</source>
            <translation>Jelöld ki a tárgyat, amelyé az animáció lesz. Csontváza kell hogy legyen.</translation>
        </message>
        <message>
            <source>%1 is an animation. Import the model that it belongs to as well, or select the object that it is for.</source>
            <translation>A(z) %1 animáció. Importáld a hozzá tartozó modellt is, vagy jelöld ki a tárgyat, amelyé lesz.</translation>
        </message>
        <message>
            <source>Looking at %1…</source>
            <translation>%1 vizsgálata…</translation>
        </message>
    </context>
    <context>
        <name>prizma::HelpActions</name>
        <message>
            <source>&amp;Keyboard Shortcuts</source>
            <translation>&amp;Gyorsbillentyűk</translation>
        </message>
        <message>
            <source>&amp;About Prizma</source>
            <translation>A Prizma &amp;névjegye</translation>
        </message>
        <message>
            <source>About &amp;Qt</source>
            <translation>A &amp;Qt névjegye</translation>
        </message>
        <message>
            <source>About Prizma</source>
            <translation>A Prizma névjegye</translation>
        </message>
        <message>
            <source>A scene editor whose view is ray traced live, on any OpenCL device.&lt;br&gt;&lt;br&gt;It grew out of Zoltán Erdős’ thesis “Valós idejű sugárkövetés” (real-time ray tracing, 2019).</source>
            <translation>Jelenetszerkesztő, amelynek képe valós idejű sugárkövetéssel készül, bármely OpenCL-eszközön.&lt;br&gt;&lt;br&gt;Erdős Zoltán „Valós idejű sugárkövetés” című szakdolgozatából (2019) nőtt ki.</translation>
        </message>
    </context>
    <context>
        <name>prizma::ImageExporter</name>
        <message>
            <source>Export the Picture</source>
            <translation>A kép mentése</translation>
        </message>
        <message>
            <source>PNG, 8 bits a channel (*.png)</source>
            <translation>PNG, csatornánként 8 bit (*.png)</translation>
        </message>
        <message>
            <source>PNG, 16 bits a channel (*.png)</source>
            <translation>PNG, csatornánként 16 bit (*.png)</translation>
        </message>
        <message>
            <source>OpenEXR, linear, 32 bits a channel (*.exr)</source>
            <translation>OpenEXR, lineáris, csatornánként 32 bit (*.exr)</translation>
        </message>
        <message>
            <source>Writing %1…</source>
            <translation>%1 írása…</translation>
        </message>
        <message>
            <source>The picture was saved, with 1 sample a pixel.</source>
            <translation>A kép elmentve, képpontonként 1 mintával.</translation>
        </message>
        <message>
            <source>The picture was saved, with %1 samples a pixel.</source>
            <translation>A kép elmentve, képpontonként %1 mintával.</translation>
        </message>
    </context>
    <context>
        <name>prizma::ImportController</name>
        <message>
            <source>Opening %1…</source>
            <translation>%1 megnyitása…</translation>
        </message>
        <message>
            <source>Importing %1…</source>
            <translation>%1 importálása…</translation>
        </message>
        <message>
            <source>The object that the animation was for is no longer there.</source>
            <translation>Már nincs meg a tárgy, amelyé az animáció lett volna.</translation>
        </message>
    </context>
    <context>
        <name>prizma::ImportOptionsDialog</name>
        <message>
            <source>Import Model</source>
            <translation>Modell importálása</translation>
        </message>
        <message>
            <source>How is &lt;b&gt;%1&lt;/b&gt; to be read?</source>
            <translation>Hogyan olvassam a(z) &lt;b&gt;%1&lt;/b&gt; fájlt?</translation>
        </message>
        <message>
            <source>How are these %1 files to be read?</source>
            <translation>Hogyan olvassam ezt a(z) %1 fájlt?</translation>
        </message>
        <message>
            <source>Y (most OBJ, FBX and glTF files)</source>
            <translation>Y (a legtöbb OBJ, FBX és glTF)</translation>
        </message>
        <message>
            <source>Z (SMD, STL and CAD files)</source>
            <translation>Z (SMD, STL és CAD)</translation>
        </message>
        <message>
            <source>The axis that points up in the file. The model is turned so that it stands upright.</source>
            <translation>A fájlban felfelé mutató tengely. A modell úgy fordul, hogy álljon.</translation>
        </message>
        <message>
            <source>Scene units for each unit of the file: 0.01 turns centimetres into metres.</source>
            <translation>Ennyi jelenetegység a fájl egy egysége: 0.01 centiméterből métert csinál.</translation>
        </message>
        <message>
            <source>Read all .%1 files in this folder this way, without asking</source>
            <translation>E mappa minden .%1 fájlját így olvassa, kérdés nélkül</translation>
        </message>
        <message>
            <source>Preferences can make the editor forget this.</source>
            <translation>A Beállításokban elfelejthető.</translation>
        </message>
        <message>
            <source>&amp;Up axis:</source>
            <translation>&amp;Felfelé:</translation>
        </message>
        <message>
            <source>&amp;Scale:</source>
            <translation>&amp;Méretarány:</translation>
        </message>
        <message>
            <source>&amp;Import</source>
            <translation>&amp;Importálás</translation>
        </message>
    </context>
    <context>
        <name>prizma::LogPanel</name>
        <message>
            <source>Message</source>
            <translation>Üzenet</translation>
        </message>
        <message>
            <source>File</source>
            <translation>Fájl</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Idő</translation>
        </message>
        <message>
            <source>%1 (%2 times)</source>
            <translation>%1 (%2-szer)</translation>
        </message>
        <message>
            <source>Show What It Is About</source>
            <translation>Mutasd, miről szól</translation>
        </message>
        <message>
            <source>Copy</source>
            <translation>Másolás</translation>
        </message>
        <message>
            <source>Clear</source>
            <translation>Ürítés</translation>
        </message>
    </context>
    <context>
        <name>prizma::MainWindow</name>
        <message>
            <source>Scene</source>
            <translation>Jelenet</translation>
        </message>
        <message>
            <source>Properties</source>
            <translation>Tulajdonságok</translation>
        </message>
        <message>
            <source>Log</source>
            <translation>Napló</translation>
        </message>
        <message>
            <source>&amp;File</source>
            <translation>&amp;Fájl</translation>
        </message>
        <message>
            <source>&amp;Edit</source>
            <translation>S&amp;zerkesztés</translation>
        </message>
        <message>
            <source>&amp;Add</source>
            <translation>&amp;Hozzáadás</translation>
        </message>
        <message>
            <source>Reset &amp;Layout</source>
            <translation>&amp;Alaphelyzet</translation>
        </message>
        <message>
            <source>Put the panels where they were at first</source>
            <translation>A panelek vissza az eredeti helyükre</translation>
        </message>
        <message>
            <source>&amp;View</source>
            <translation>&amp;Nézet</translation>
        </message>
        <message>
            <source>&amp;Render</source>
            <translation>&amp;Képalkotás</translation>
        </message>
        <message>
            <source>&amp;Help</source>
            <translation>&amp;Súgó</translation>
        </message>
        <message>
            <source>Saved %1</source>
            <translation>%1 elmentve</translation>
        </message>
        <message>
            <source>Imported %1</source>
            <translation>%1 importálva</translation>
        </message>
        <message>
            <source>Nothing in the scene comes from %1.</source>
            <translation>A jelenetben semmi sem a(z) %1 fájlból való.</translation>
        </message>
        <message>
            <source> – %1 FPS</source>
            <translation> – %1 FPS</translation>
        </message>
        <message>
            <source>Timeline</source>
            <translation>Idővonal</translation>
        </message>
        <message>
            <source>&amp;Playback</source>
            <translation>&amp;Lejátszás</translation>
        </message>
        <message>
            <source>%1 has a new clip</source>
            <translation>%1 új mozgást kapott</translation>
        </message>
        <message>
            <source>%1 has %2 new clips</source>
            <translation>%1 %2 új mozgást kapott</translation>
        </message>
    </context>
    <context>
        <name>prizma::MaterialSlots</name>
        <message>
            <source>Materials</source>
            <translation>Anyagok</translation>
        </message>
        <message>
            <source>Slot %1</source>
            <translation>%1. hely</translation>
        </message>
        <message>
            <source>Edit this material</source>
            <translation>Az anyag szerkesztése</translation>
        </message>
        <message>
            <source>Assign a new material</source>
            <translation>Új anyag hozzárendelése</translation>
        </message>
    </context>
    <context>
        <name>prizma::PlaybackActions</name>
        <message>
            <source>&amp;Play</source>
            <translation>&amp;Lejátszás</translation>
        </message>
        <message>
            <source>Play the timeline, or pause it</source>
            <translation>Az idővonal lejátszása vagy szüneteltetése</translation>
        </message>
        <message>
            <source>Play &amp;Backwards</source>
            <translation>Lejátszás &amp;visszafelé</translation>
        </message>
        <message>
            <source>Play the timeline the other way, or pause it</source>
            <translation>Az idővonal lejátszása visszafelé, vagy szünet</translation>
        </message>
        <message>
            <source>&amp;Stop</source>
            <translation>&amp;Megállítás</translation>
        </message>
        <message>
            <source>Pause, and go back to the start</source>
            <translation>Szünet, és vissza az elejére</translation>
        </message>
        <message>
            <source>P&amp;revious Frame</source>
            <translation>&amp;Előző képkocka</translation>
        </message>
        <message>
            <source>Go back a frame</source>
            <translation>Egy képkockával vissza</translation>
        </message>
        <message>
            <source>&amp;Next Frame</source>
            <translation>&amp;Következő képkocka</translation>
        </message>
        <message>
            <source>Go on a frame</source>
            <translation>Egy képkockával tovább</translation>
        </message>
        <message>
            <source>&amp;First Frame</source>
            <translation>E&amp;lső képkocka</translation>
        </message>
        <message>
            <source>Go to the start of the timeline</source>
            <translation>Az idővonal elejére</translation>
        </message>
        <message>
            <source>&amp;Last Frame</source>
            <translation>&amp;Utolsó képkocka</translation>
        </message>
        <message>
            <source>Go to the end of the timeline</source>
            <translation>Az idővonal végére</translation>
        </message>
        <message>
            <source>L&amp;oop</source>
            <translation>&amp;Ismétlés</translation>
        </message>
        <message>
            <source>On&amp;ce</source>
            <translation>E&amp;gyszer</translation>
        </message>
        <message>
            <source>Back and For&amp;th</source>
            <translation>&amp;Oda-vissza</translation>
        </message>
        <message>
            <source>&amp;Pause</source>
            <translation>&amp;Szünet</translation>
        </message>
    </context>
    <context>
        <name>prizma::PreferencesDialog</name>
        <message>
            <source>Open the &amp;log when something goes wrong</source>
            <translation>A &amp;napló nyíljon meg, ha hiba történik</translation>
        </message>
        <message>
            <source>Open the &amp;demo scene at start</source>
            <translation>Induláskor a &amp;bemutató jelenet nyíljon meg</translation>
        </message>
        <message>
            <source>Preferences</source>
            <translation>Beállítások</translation>
        </message>
        <message>
            <source>General</source>
            <translation>Általános</translation>
        </message>
        <message>
            <source>Lan&amp;guage:</source>
            <translation>N&amp;yelv:</translation>
        </message>
        <message>
            <source>Another language comes with the next start.</source>
            <translation>Az új nyelv a következő indításkor lép életbe.</translation>
        </message>
        <message>
            <source>Import</source>
            <translation>Importálás</translation>
        </message>
        <message>
            <source>&amp;Forget Remembered Options</source>
            <translation>A megjegyzett választások &amp;elfelejtése</translation>
        </message>
        <message>
            <source>Ask again for the up axis and the scale of model files, whatever was remembered.</source>
            <translation>Kérdezzen újra a modellek tengelyéről és méretéről.</translation>
        </message>
        <message>
            <source>As the system</source>
            <translation>A rendszeré</translation>
        </message>
    </context>
    <context>
        <name>prizma::PropertyEditor</name>
        <message>
            <source>Select something in the scene tree or in the view to see its properties.</source>
            <translation>Jelölj ki valamit a fában vagy a képen, hogy lásd a tulajdonságait.</translation>
        </message>
        <message>
            <source>Reading %1…</source>
            <translation>%1 olvasása…</translation>
        </message>
        <message>
            <source>Bind pose</source>
            <translation>Alapállás</translation>
        </message>
    </context>
    <context>
        <name>prizma::PropertyRow</name>
        <message>
            <source>Back to the default</source>
            <translation>Vissza az alapértékre</translation>
        </message>
    </context>
    <context>
        <name>prizma::RangeBar</name>
        <message>
            <source>Start</source>
            <translation>Kezdet</translation>
        </message>
        <message>
            <source>Frames a second</source>
            <translation>Képkocka/s</translation>
        </message>
        <message>
            <source>End</source>
            <translation>Vég</translation>
        </message>
        <message>
            <source>Make start, end and frame rate those of the clip</source>
            <translation>A kezdet, a vég és a sebesség legyen a mozgásé</translation>
        </message>
    </context>
    <context>
        <name>prizma::RecentFiles</name>
        <message>
            <source>No Recent Files</source>
            <translation>Nincsenek</translation>
        </message>
        <message>
            <source>Clear List</source>
            <translation>Lista ürítése</translation>
        </message>
    </context>
    <context>
        <name>prizma::SceneModel</name>
        <message>
            <source>Objects</source>
            <translation>Tárgyak</translation>
        </message>
        <message>
            <source>Lights</source>
            <translation>Fények</translation>
        </message>
        <message>
            <source>Materials</source>
            <translation>Anyagok</translation>
        </message>
        <message>
            <source>Dynamic: its vertices move</source>
            <translation>Dinamikus: a csúcsai mozognak</translation>
        </message>
        <message>
            <source>Static: its shape does not change</source>
            <translation>Statikus: az alakja nem változik</translation>
        </message>
        <message>
            <source>Hide it</source>
            <translation>Elrejtés</translation>
        </message>
        <message>
            <source>Show it</source>
            <translation>Megjelenítés</translation>
        </message>
        <message>
            <source>Switch it off</source>
            <translation>Kikapcsolás</translation>
        </message>
        <message>
            <source>Switch it on</source>
            <translation>Bekapcsolás</translation>
        </message>
    </context>
    <context>
        <name>prizma::SceneTree</name>
        <message>
            <source>Filter</source>
            <translation>Szűrés</translation>
        </message>
        <message>
            <source>Rename</source>
            <translation>Átnevezés</translation>
        </message>
    </context>
    <context>
        <name>prizma::ShortcutSheet</name>
        <message>
            <source>Orbit</source>
            <translation>Körüljárás</translation>
        </message>
        <message>
            <source>Left drag</source>
            <translation>Bal gombbal húzás</translation>
        </message>
        <message>
            <source>Pan</source>
            <translation>Eltolás</translation>
        </message>
        <message>
            <source>Middle drag, Shift+left drag</source>
            <translation>Középső gombbal vagy Shift+bal gombbal húzás</translation>
        </message>
        <message>
            <source>Zoom to the pointer</source>
            <translation>Nagyítás a mutatónál</translation>
        </message>
        <message>
            <source>Wheel, right drag</source>
            <translation>Görgő, jobb gombbal húzás</translation>
        </message>
        <message>
            <source>Select</source>
            <translation>Kijelölés</translation>
        </message>
        <message>
            <source>Click</source>
            <translation>Kattintás</translation>
        </message>
        <message>
            <source>Cancel a drag</source>
            <translation>Húzás megszakítása</translation>
        </message>
        <message>
            <source>Esc</source>
            <translation>Esc</translation>
        </message>
        <message>
            <source>Menu of the view</source>
            <translation>A kép menüje</translation>
        </message>
        <message>
            <source>Right click</source>
            <translation>Jobb kattintás</translation>
        </message>
        <message>
            <source>Change a number</source>
            <translation>Szám módosítása</translation>
        </message>
        <message>
            <source>Drag the field or its name</source>
            <translation>A mező vagy a neve húzása</translation>
        </message>
        <message>
            <source>… finely / in whole steps</source>
            <translation>… finoman / egész lépésekben</translation>
        </message>
        <message>
            <source>Shift / Ctrl while dragging</source>
            <translation>Shift / Ctrl húzás közben</translation>
        </message>
        <message>
            <source>Step a number</source>
            <translation>Szám léptetése</translation>
        </message>
        <message>
            <source>Up, Down, wheel</source>
            <translation>Fel, Le, görgő</translation>
        </message>
        <message>
            <source>Type an expression</source>
            <translation>Kifejezés beírása</translation>
        </message>
        <message>
            <source>Leave a number as it was</source>
            <translation>A szám maradjon a régi</translation>
        </message>
        <message>
            <source>Rename in the scene tree</source>
            <translation>Átnevezés a fában</translation>
        </message>
        <message>
            <source>F2, double click</source>
            <translation>F2, dupla kattintás</translation>
        </message>
        <message>
            <source>Keyboard Shortcuts</source>
            <translation>Gyorsbillentyűk</translation>
        </message>
        <message>
            <source>Search commands and keys</source>
            <translation>Parancs vagy billentyű keresése</translation>
        </message>
        <message>
            <source>Command</source>
            <translation>Parancs</translation>
        </message>
        <message>
            <source>Keys</source>
            <translation>Billentyűk</translation>
        </message>
        <message>
            <source>In the view</source>
            <translation>A képen</translation>
        </message>
        <message>
            <source>In the panels</source>
            <translation>A paneleken</translation>
        </message>
        <message>
            <source>Move in time</source>
            <translation>Ugrás az időben</translation>
        </message>
        <message>
            <source>Left drag on the ruler</source>
            <translation>Húzás a vonalzón</translation>
        </message>
        <message>
            <source>… also between frames</source>
            <translation>… képkockák között is</translation>
        </message>
        <message>
            <source>Shift while dragging</source>
            <translation>Shift húzás közben</translation>
        </message>
        <message>
            <source>Zoom and move the ruler</source>
            <translation>A vonalzó nagyítása és eltolása</translation>
        </message>
        <message>
            <source>Wheel, middle drag</source>
            <translation>Görgő, húzás a középső gombbal</translation>
        </message>
        <message>
            <source>Show the whole ruler</source>
            <translation>A teljes vonalzó</translation>
        </message>
        <message>
            <source>Double click</source>
            <translation>Dupla kattintás</translation>
        </message>
        <message>
            <source>See what a clip looks like</source>
            <translation>Mozgás megtekintése</translation>
        </message>
        <message>
            <source>Point at it, Up, Down</source>
            <translation>Rámutatás, Fel, Le</translation>
        </message>
        <message>
            <source>Choose a clip</source>
            <translation>Mozgás kiválasztása</translation>
        </message>
        <message>
            <source>Click, Return</source>
            <translation>Kattintás, Enter</translation>
        </message>
        <message>
            <source>Fit the timeline to a clip</source>
            <translation>Az idővonal igazítása a mozgáshoz</translation>
        </message>
        <message>
            <source>In the timeline</source>
            <translation>Az idővonalon</translation>
        </message>
    </context>
    <context>
        <name>prizma::SkeletonOverlay</name>
        <message>
            <source>Skeletons</source>
            <translation>Csontvázak</translation>
        </message>
    </context>
    <context>
        <name>prizma::StatisticsOverlay</name>
        <message>
            <source>%1 M/s</source>
            <translation>%1 M/s</translation>
        </message>
        <message>
            <source>%1 ms</source>
            <translation>%1 ms</translation>
        </message>
        <message>
            <source>Statistics</source>
            <translation>Statisztika</translation>
        </message>
        <message>
            <source>Frames a second</source>
            <translation>Kép másodpercenként</translation>
        </message>
        <message>
            <source>Samples</source>
            <translation>Minták</translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation>Felbontás</translation>
        </message>
        <message>
            <source>Rays</source>
            <translation>Sugarak</translation>
        </message>
        <message>
            <source>Triangles</source>
            <translation>Háromszögek</translation>
        </message>
        <message>
            <source>Device memory</source>
            <translation>Eszközmemória</translation>
        </message>
        <message>
            <source>1 object</source>
            <translation>1 tárgy</translation>
        </message>
        <message numerus="yes">
            <source>%n objects</source>
            <translation>
                <numerusform>%n tárgy</numerusform>
            </translation>
        </message>
        <message>
            <source>denoised preview</source>
            <translation>zajszűrt előnézet</translation>
        </message>
        <message>
            <source>Pixels without a number</source>
            <translation>Szám nélküli képpontok</translation>
        </message>
    </context>
    <context>
        <name>prizma::StatusBar</name>
        <message>
            <source>Cancel</source>
            <translation>Mégse</translation>
        </message>
        <message>
            <source>Samples in each pixel so far, and how many there will be</source>
            <translation>Minták képpontonként eddig, és hány lesz</translation>
        </message>
        <message>
            <source>The device that renders; click to choose another one</source>
            <translation>A számoló eszköz; kattintásra másik választható</translation>
        </message>
        <message>
            <source>No device</source>
            <translation>Nincs eszköz</translation>
        </message>
        <message>
            <source>%1…</source>
            <translation>%1…</translation>
        </message>
        <message>
            <source>%1 of %2 samples</source>
            <translation>%1/%2 minta</translation>
        </message>
        <message>
            <source>Denoised preview</source>
            <translation>Zajszűrt előnézet</translation>
        </message>
        <message>
            <source>The picture in the view is smoothed; files are written as it is</source>
            <translation>A nézet képe simított; a fájlokba simítás nélkül kerül</translation>
        </message>
    </context>
    <context>
        <name>prizma::TextureEditor</name>
        <message>
            <source>None</source>
            <translation>Nincs</translation>
        </message>
        <message>
            <source>Choose a picture…</source>
            <translation>Kép választása…</translation>
        </message>
        <message>
            <source>Remove the picture</source>
            <translation>Kép eltávolítása</translation>
        </message>
        <message>
            <source>%1 could not be read.</source>
            <translation>%1 nem olvasható.</translation>
        </message>
        <message>
            <source>Choose a Picture</source>
            <translation>Kép választása</translation>
        </message>
        <message>
            <source>Pictures (*.png *.jpg *.jpeg *.bmp *.tga *.gif *.psd *.hdr *.exr)</source>
            <translation>Képek (*.png *.jpg *.jpeg *.bmp *.tga *.gif *.psd *.hdr *.exr)</translation>
        </message>
        <message>
            <source>All files (*)</source>
            <translation>Minden fájl (*)</translation>
        </message>
    </context>
    <context>
        <name>prizma::TimelineRuler</name>
        <message>
            <source>Timeline</source>
            <translation>Idővonal</translation>
        </message>
        <message>
            <source>Drag to move in time; turn the wheel to zoom, double-click to see all</source>
            <translation>Húzással mozogsz az időben; a görgő nagyít, dupla kattintásra minden látszik</translation>
        </message>
    </context>
    <context>
        <name>prizma::TransportBar</name>
        <message>
            <source>What comes after the last frame</source>
            <translation>Mi jön az utolsó képkocka után</translation>
        </message>
        <message>
            <source>Speed</source>
            <translation>Sebesség</translation>
        </message>
        <message>
            <source>1 is real time; below 0 it plays backwards</source>
            <translation>1: valós idő; 0 alatt visszafelé játszik</translation>
        </message>
        <message>
            <source>Frame</source>
            <translation>Kocka</translation>
        </message>
        <message>
            <source>The frame that is shown</source>
            <translation>A látható képkocka</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Idő</translation>
        </message>
        <message>
            <source>Where that is in seconds</source>
            <translation>Ugyanez másodpercben</translation>
        </message>
    </context>
    <context>
        <name>prizma::UnsavedChanges</name>
        <message>
            <source>Unsaved Changes</source>
            <translation>Mentetlen változások</translation>
        </message>
        <message>
            <source>Save the changes to “%1”?</source>
            <translation>Elmented a(z) „%1” változásait?</translation>
        </message>
        <message>
            <source>Without saving, they are lost.</source>
            <translation>Mentés nélkül elvesznek.</translation>
        </message>
    </context>
    <context>
        <name>prizma::ViewActions</name>
        <message>
            <source>&amp;Frame Selected</source>
            <translation>&amp;Kijelöltek képbe</translation>
        </message>
        <message>
            <source>Frame &amp;All</source>
            <translation>&amp;Minden képbe</translation>
        </message>
        <message>
            <source>&amp;Pause Rendering</source>
            <translation>&amp;Szünet</translation>
        </message>
        <message>
            <source>&amp;Statistics</source>
            <translation>S&amp;tatisztika</translation>
        </message>
        <message>
            <source>Move the camera so that what is selected fills the view</source>
            <translation>A kamera a kijelöltekhez megy</translation>
        </message>
        <message>
            <source>Move the camera so that the whole scene is in the view</source>
            <translation>A kamera az egész jelenetet mutatja</translation>
        </message>
        <message>
            <source>Keep the picture as it is and leave the device alone</source>
            <translation>A kép marad, az eszköz pihen</translation>
        </message>
        <message>
            <source>Show what the picture cost, over the view</source>
            <translation>A kép költségei a képen</translation>
        </message>
        <message>
            <source>View from the F&amp;ront</source>
            <translation>&amp;Elölnézet</translation>
        </message>
        <message>
            <source>View from the S&amp;ide</source>
            <translation>&amp;Oldalnézet</translation>
        </message>
        <message>
            <source>View from the &amp;Top</source>
            <translation>&amp;Felülnézet</translation>
        </message>
        <message>
            <source>Pa&amp;nels</source>
            <translation>&amp;Panelek</translation>
        </message>
        <message>
            <source>F&amp;ull Screen</source>
            <translation>Te&amp;ljes képernyő</translation>
        </message>
        <message>
            <source>OpenCL &amp;Devices…</source>
            <translation>OpenCL-&amp;eszközök…</translation>
        </message>
        <message>
            <source>Choose what renders</source>
            <translation>A számoló eszköz kiválasztása</translation>
        </message>
        <message>
            <source>&amp;Shader</source>
            <translation>Á&amp;rnyaló</translation>
        </message>
        <message>
            <source>Render S&amp;ettings</source>
            <translation>Képalkotás &amp;beállításai</translation>
        </message>
        <message>
            <source>Show samples, depth and exposure in the property panel</source>
            <translation>Minták, mélység, expozíció a tulajdonságok közt</translation>
        </message>
        <message>
            <source>S&amp;keletons</source>
            <translation>&amp;Csontvázak</translation>
        </message>
        <message>
            <source>Show the bones of what is selected, or of everything, over the view</source>
            <translation>A kijelöltek vagy minden csontjai a képen</translation>
        </message>
        <message>
            <source>&amp;Denoise Preview</source>
            <translation>&amp;Zajszűrt előnézet</translation>
        </message>
        <message>
            <source>Smooth the picture in the view along surfaces; files stay as they are</source>
            <translation>A nézet képének simítása a felületek mentén; a fájlok nem változnak</translation>
        </message>
        <message>
            <source>&amp;Colours</source>
            <translation>S&amp;zínek</translation>
        </message>
    </context>
    <context>
        <name>prizma::Viewport</name>
        <message>
            <source>Viewport</source>
            <translation>Kép</translation>
        </message>
    </context>
    <context>
        <name>prizma::ViewportMenu</name>
        <message>
            <source>Looking for devices…</source>
            <translation>Eszközök keresése…</translation>
        </message>
        <message>
            <source>OpenCL &amp;Device</source>
            <translation>OpenCL-&amp;eszköz</translation>
        </message>
        <message>
            <source>No device found</source>
            <translation>Nincs eszköz</translation>
        </message>
        <message>
            <source>All About Them…</source>
            <translation>Részletesen…</translation>
        </message>
    </context>
    <context>
        <name>properties</name>
        <message>
            <source>Name</source>
            <translation>Név</translation>
        </message>
        <message>
            <source>What the object is called in the scene tree.</source>
            <translation>A tárgy neve a fában.</translation>
        </message>
        <message>
            <source>Visible</source>
            <translation>Látható</translation>
        </message>
        <message>
            <source>A hidden object is neither drawn nor animated.</source>
            <translation>A rejtett tárgy nem rajzolódik és nem mozog.</translation>
        </message>
        <message>
            <source>Dynamic</source>
            <translation>Dinamikus</translation>
        </message>
        <message>
            <source>Its vertices move: they are shaded and its tree is refitted when it changes.</source>
            <translation>A csúcsai mozognak: változáskor újraszámolódnak, és a fája hozzájuk igazodik.</translation>
        </message>
        <message>
            <source>Position</source>
            <translation>Hely</translation>
        </message>
        <message>
            <source>Where the object's origin is.</source>
            <translation>Ahol a tárgy origója van.</translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation>Forgatás</translation>
        </message>
        <message>
            <source>Turns about X, then Y, then Z.</source>
            <translation>Forgatás X, majd Y, majd Z körül.</translation>
        </message>
        <message>
            <source>Scale</source>
            <translation>Méret</translation>
        </message>
        <message>
            <source>Size along each axis; 1 is the model's own.</source>
            <translation>Méretarány tengelyenként; 1 a modellé.</translation>
        </message>
        <message>
            <source>Clip</source>
            <translation>Mozgás</translation>
        </message>
        <message>
            <source>The animation that plays; empty for the bind pose.</source>
            <translation>A lejátszott mozgás; üresen az alapállás.</translation>
        </message>
        <message>
            <source>As the clip says</source>
            <translation>Ahogy a mozgás előírja</translation>
        </message>
        <message>
            <source>Loop</source>
            <translation>Ismétlés</translation>
        </message>
        <message>
            <source>Once</source>
            <translation>Egyszer</translation>
        </message>
        <message>
            <source>Back and forth</source>
            <translation>Oda-vissza</translation>
        </message>
        <message>
            <source>Clip offset</source>
            <translation>Mozgás eltolása</translation>
        </message>
        <message>
            <source>How far into the clip the timeline's beginning is.</source>
            <translation>Hol tart a mozgás, amikor az idővonal az elején áll.</translation>
        </message>
        <message>
            <source>Speed</source>
            <translation>Sebesség</translation>
        </message>
        <message>
            <source>1 is the clip's own speed, 0 stands still, below 0 runs backwards.</source>
            <translation>1 a mozgás saját sebessége, 0 áll, 0 alatt visszafelé halad.</translation>
        </message>
        <message>
            <source>What the clip does after its end.</source>
            <translation>Mi történik, amikor a mozgás a végére ér.</translation>
        </message>
        <message>
            <source>Clip's frame rate</source>
            <translation>A mozgás képsebessége</translation>
        </message>
        <message>
            <source>Frames of the clip a second; 0 is the clip's own rate.</source>
            <translation>A mozgás képkockái másodpercenként; 0: a mozgás sajátja.</translation>
        </message>
        <message>
            <source>Fade</source>
            <translation>Átmenet</translation>
        </message>
        <message>
            <source>How long it takes to go over to the clip; 0 for no fade.</source>
            <translation>Mennyi ideig tart az átmenet a mozgásba; 0: nincs átmenet.</translation>
        </message>
        <message>
            <source>Fade starts</source>
            <translation>Átmenet kezdete</translation>
        </message>
        <message>
            <source>When on the timeline the fade begins.</source>
            <translation>Mikor kezdődik az átmenet az idővonalon.</translation>
        </message>
        <message>
            <source>Fade from</source>
            <translation>Átmenet ebből</translation>
        </message>
        <message>
            <source>The clip that plays before; empty for the bind pose.</source>
            <translation>Az előtte lejátszott mozgás; üresen az alapállás.</translation>
        </message>
        <message>
            <source>How far the shape is blended in; 1 is all of it.</source>
            <translation>Mennyire érvényesül az alak; 1: teljesen.</translation>
        </message>
        <message>
            <source>What the light is called in the scene tree.</source>
            <translation>A fény neve a fában.</translation>
        </message>
        <message>
            <source>On</source>
            <translation>Bekapcsolva</translation>
        </message>
        <message>
            <source>A light that is off costs nothing.</source>
            <translation>A kikapcsolt fény semmibe sem kerül.</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>Fajta</translation>
        </message>
        <message>
            <source>What kind of light it is.</source>
            <translation>Miféle fény.</translation>
        </message>
        <message>
            <source>Colour</source>
            <translation>Szín</translation>
        </message>
        <message>
            <source>Multiplies the strength; linear RGB.</source>
            <translation>Szorozza az erősséget; lineáris RGB.</translation>
        </message>
        <message>
            <source>Intensity</source>
            <translation>Intenzitás</translation>
        </message>
        <message>
            <source>Power sent into a unit of solid angle.</source>
            <translation>Teljesítmény egységnyi térszögbe.</translation>
        </message>
        <message>
            <source>Irradiance</source>
            <translation>Besugárzás</translation>
        </message>
        <message>
            <source>Power on a unit of area that faces the light.</source>
            <translation>Teljesítmény a fény felé néző egységnyi felületen.</translation>
        </message>
        <message>
            <source>Radiance</source>
            <translation>Sugársűrűség</translation>
        </message>
        <message>
            <source>Power a unit of area sends into a unit of solid angle.</source>
            <translation>Egységnyi felület teljesítménye egységnyi térszögbe.</translation>
        </message>
        <message>
            <source>Where the light is.</source>
            <translation>Ahol a fény van.</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>Irány</translation>
        </message>
        <message>
            <source>Where the light travels.</source>
            <translation>Amerre a fény halad.</translation>
        </message>
        <message>
            <source>Inner angle</source>
            <translation>Belső szög</translation>
        </message>
        <message>
            <source>Full intensity within this angle of the axis.</source>
            <translation>E szögön belül teljes az intenzitás.</translation>
        </message>
        <message>
            <source>Outer angle</source>
            <translation>Külső szög</translation>
        </message>
        <message>
            <source>No light beyond this angle of the axis.</source>
            <translation>E szögön túl nincs fény.</translation>
        </message>
        <message>
            <source>Turns about X, then Y, then Z; unturned it shines down.</source>
            <translation>Forgatás X, majd Y, majd Z körül; alaphelyzetben lefelé világít.</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Méret</translation>
        </message>
        <message>
            <source>Width and depth.</source>
            <translation>Szélesség és mélység.</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>Sugár</translation>
        </message>
        <message>
            <source>Of the sphere.</source>
            <translation>A gömbé.</translation>
        </message>
        <message>
            <source>What the material is called.</source>
            <translation>Az anyag neve.</translation>
        </message>
        <message>
            <source>Base colour</source>
            <translation>Alapszín</translation>
        </message>
        <message>
            <source>Share of light that is reflected; linear RGB.</source>
            <translation>A visszavert fény aránya; lineáris RGB.</translation>
        </message>
        <message>
            <source>Base texture</source>
            <translation>Alaptextúra</translation>
        </message>
        <message>
            <source>Multiplies the base colour.</source>
            <translation>Szorozza az alapszínt.</translation>
        </message>
        <message>
            <source>Alpha</source>
            <translation>Alfa</translation>
        </message>
        <message>
            <source>0 is a hole, 1 is solid.</source>
            <translation>0: lyuk, 1: tömör.</translation>
        </message>
        <message>
            <source>Specular</source>
            <translation>Tükröződés</translation>
        </message>
        <message>
            <source>Strength of the reflection of a non-metal.</source>
            <translation>Nemfémek tükröződésének erőssége.</translation>
        </message>
        <message>
            <source>Metallic</source>
            <translation>Fémesség</translation>
        </message>
        <message>
            <source>1 reflects in its base colour, as metals do.</source>
            <translation>1: alapszínében tükröz, mint a fémek.</translation>
        </message>
        <message>
            <source>Roughness</source>
            <translation>Érdesség</translation>
        </message>
        <message>
            <source>0 is polished, 1 is matt.</source>
            <translation>0: fényes, 1: matt.</translation>
        </message>
        <message>
            <source>Transmission</source>
            <translation>Áteresztés</translation>
        </message>
        <message>
            <source>1 lets light through, as glass does.</source>
            <translation>1: átereszti a fényt, mint az üveg.</translation>
        </message>
        <message>
            <source>Refraction index</source>
            <translation>Törésmutató</translation>
        </message>
        <message>
            <source>1 air, 1.33 water, 1.5 glass, 2.42 diamond.</source>
            <translation>1 levegő, 1.33 víz, 1.5 üveg, 2.42 gyémánt.</translation>
        </message>
        <message>
            <source>Emission</source>
            <translation>Kibocsátás</translation>
        </message>
        <message>
            <source>Light that the surface sends out; linear RGB.</source>
            <translation>A felület saját fénye; lineáris RGB.</translation>
        </message>
        <message>
            <source>Emission strength</source>
            <translation>Kibocsátás ereje</translation>
        </message>
        <message>
            <source>Multiplies the emission.</source>
            <translation>Szorozza a kibocsátást.</translation>
        </message>
        <message>
            <source>Normal map</source>
            <translation>Normáltérkép</translation>
        </message>
        <message>
            <source>Bends the surface's normal.</source>
            <translation>Elhajlítja a felület normálisát.</translation>
        </message>
        <message>
            <source>Where the camera is.</source>
            <translation>Ahol a kamera van.</translation>
        </message>
        <message>
            <source>Target</source>
            <translation>Célpont</translation>
        </message>
        <message>
            <source>What it looks at and orbits.</source>
            <translation>Amit néz és körüljár.</translation>
        </message>
        <message>
            <source>Up</source>
            <translation>Felfelé</translation>
        </message>
        <message>
            <source>The direction that is up in the picture.</source>
            <translation>A képen felfelé mutató irány.</translation>
        </message>
        <message>
            <source>Field of view</source>
            <translation>Látószög</translation>
        </message>
        <message>
            <source>Vertical opening angle.</source>
            <translation>Függőleges nyílásszög.</translation>
        </message>
        <message>
            <source>What rays that leave the scene see.</source>
            <translation>Amit a jelenetből kilépő sugarak látnak.</translation>
        </message>
        <message>
            <source>Image</source>
            <translation>Kép</translation>
        </message>
        <message>
            <source>An equirectangular picture around the scene.</source>
            <translation>Gömbi panoráma a jelenet körül.</translation>
        </message>
        <message>
            <source>Multiplies colour or image.</source>
            <translation>Szorozza a színt vagy a képet.</translation>
        </message>
        <message>
            <source>Frame rate</source>
            <translation>Képkockasebesség</translation>
        </message>
        <message>
            <source>Frames a second.</source>
            <translation>Képkocka másodpercenként.</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Kezdet</translation>
        </message>
        <message>
            <source>The first frame.</source>
            <translation>Az első képkocka.</translation>
        </message>
        <message>
            <source>End</source>
            <translation>Vég</translation>
        </message>
        <message>
            <source>The last frame.</source>
            <translation>Az utolsó képkocka.</translation>
        </message>
        <message>
            <source>Frame</source>
            <translation>Képkocka</translation>
        </message>
        <message>
            <source>The frame that is shown.</source>
            <translation>A látható képkocka.</translation>
        </message>
        <message>
            <source>Shader</source>
            <translation>Árnyaló</translation>
        </message>
        <message>
            <source>What is drawn where a ray hits.</source>
            <translation>Amit a sugár találata mutat.</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Mélység</translation>
        </message>
        <message>
            <source>How often a ray may be reflected or refracted.</source>
            <translation>Hányszor verődhet vissza vagy törhet meg egy sugár.</translation>
        </message>
        <message>
            <source>Samples</source>
            <translation>Minták</translation>
        </message>
        <message>
            <source>A pixel is done after this many.</source>
            <translation>Ennyi után kész egy képpont.</translation>
        </message>
        <message>
            <source>Exposure</source>
            <translation>Expozíció</translation>
        </message>
        <message>
            <source>Brightness of the display.</source>
            <translation>A megjelenítés fényereje.</translation>
        </message>
        <message>
            <source>Point</source>
            <translation>Pont</translation>
        </message>
        <message>
            <source>Spot</source>
            <translation>Reflektor</translation>
        </message>
        <message>
            <source>Directional</source>
            <translation>Irányított</translation>
        </message>
        <message>
            <source>Rectangle</source>
            <translation>Téglalap</translation>
        </message>
        <message>
            <source>Sphere</source>
            <translation>Gömb</translation>
        </message>
        <message>
            <source>Whitted</source>
            <translation>Whitted</translation>
        </message>
        <message>
            <source>Normals</source>
            <translation>Normálisok</translation>
        </message>
        <message>
            <source>Texture coordinates</source>
            <translation>Textúrakoordináták</translation>
        </message>
        <message>
            <source>Traversal cost</source>
            <translation>Bejárás költsége</translation>
        </message>
        <message>
            <source>Plane</source>
            <translation>Sík</translation>
        </message>
        <message>
            <source>Cube</source>
            <translation>Kocka</translation>
        </message>
        <message>
            <source>Cylinder</source>
            <translation>Henger</translation>
        </message>
        <message>
            <source>Torus</source>
            <translation>Tórusz</translation>
        </message>
        <message>
            <source>Camera</source>
            <translation>Kamera</translation>
        </message>
        <message>
            <source>Background</source>
            <translation>Háttér</translation>
        </message>
        <message>
            <source>Timeline</source>
            <translation>Idővonal</translation>
        </message>
        <message>
            <source>Render settings</source>
            <translation>Képalkotás</translation>
        </message>
        <message>
            <source>stops</source>
            <translation>fényérték</translation>
        </message>
        <message>
            <source>the last frame comes before the first</source>
            <translation>az utolsó képkocka az első előtt van</translation>
        </message>
        <message>
            <source>several frames need #### in the pictures' name</source>
            <translation>több képkockához #### kell a képek nevébe</translation>
        </message>
        <message>
            <source>ffmpeg, which makes the videos, is not installed</source>
            <translation>nincs telepítve az ffmpeg, amely a videókat készíti</translation>
        </message>
        <message>
            <source>Placement</source>
            <translation>Elhelyezés</translation>
        </message>
        <message>
            <source>Animation</source>
            <translation>Animáció</translation>
        </message>
        <message>
            <source>Shapes</source>
            <translation>Alakok</translation>
        </message>
        <message>
            <source>Light</source>
            <translation>Fény</translation>
        </message>
        <message>
            <source>Holes</source>
            <translation>Lyukak</translation>
        </message>
        <message>
            <source>Reflection</source>
            <translation>Tükrözés</translation>
        </message>
        <message>
            <source>Glass</source>
            <translation>Üveg</translation>
        </message>
        <message>
            <source>Relief</source>
            <translation>Domborzat</translation>
        </message>
        <message>
            <source>Lens</source>
            <translation>Lencse</translation>
        </message>
        <message>
            <source>Display</source>
            <translation>Megjelenítés</translation>
        </message>
        <message>
            <source>The camera sees the light itself, not only what it lights.</source>
            <translation>A kamera magát a fényt is látja, nemcsak azt, amit megvilágít.</translation>
        </message>
        <message>
            <source>Alpha mode</source>
            <translation>Alfa módja</translation>
        </message>
        <message>
            <source>Blend mixes, Mask cuts holes, Opaque takes no notice of alpha.</source>
            <translation>A Keverés átereszt, a Maszk lyukat vág, az Átlátszatlan nem törődik az alfával.</translation>
        </message>
        <message>
            <source>Alpha cut-off</source>
            <translation>Alfa határa</translation>
        </message>
        <message>
            <source>Below it there is a hole.</source>
            <translation>Ez alatt lyuk van.</translation>
        </message>
        <message>
            <source>Double-sided</source>
            <translation>Kétoldalas</translation>
        </message>
        <message>
            <source>Otherwise the surface is not there when seen from behind.</source>
            <translation>Különben a felület hátulról nézve nincs ott.</translation>
        </message>
        <message>
            <source>Specular colour</source>
            <translation>Tükrözés színe</translation>
        </message>
        <message>
            <source>Tints the reflection of a non-metal; linear RGB.</source>
            <translation>A nem fémes tükrözés árnyalata; lineáris RGB.</translation>
        </message>
        <message>
            <source>Specular texture</source>
            <translation>Tükrözés textúrája</translation>
        </message>
        <message>
            <source>Its alpha multiplies the specular strength.</source>
            <translation>Az alfája szorozza a tükrözés erősségét.</translation>
        </message>
        <message>
            <source>Metallic and roughness texture</source>
            <translation>Fémesség és érdesség textúrája</translation>
        </message>
        <message>
            <source>Its blue multiplies metallic, its green roughness.</source>
            <translation>A kékje a fémességet, a zöldje az érdességet szorozza.</translation>
        </message>
        <message>
            <source>Transmission texture</source>
            <translation>Áteresztés textúrája</translation>
        </message>
        <message>
            <source>Its red multiplies the transmission.</source>
            <translation>A vöröse szorozza az áteresztést.</translation>
        </message>
        <message>
            <source>Absorption colour</source>
            <translation>Elnyelés színe</translation>
        </message>
        <message>
            <source>What is left of white light after the absorption distance inside.</source>
            <translation>Ami a fehér fényből az elnyelési távolság után belül megmarad.</translation>
        </message>
        <message>
            <source>Absorption distance</source>
            <translation>Elnyelési távolság</translation>
        </message>
        <message>
            <source>How far light goes inside until it has the absorption colour; 0: nothing is absorbed.</source>
            <translation>Amennyit a fény belül megtesz, amíg ilyen színű lesz; 0: semmi sem nyelődik el.</translation>
        </message>
        <message>
            <source>Emission texture</source>
            <translation>Kibocsátás textúrája</translation>
        </message>
        <message>
            <source>Normal strength</source>
            <translation>Normálok ereje</translation>
        </message>
        <message>
            <source>How far the normal map bends the normal; 1 is as painted.</source>
            <translation>Mennyire hajlítja a normáltérkép a normálist; 1: ahogy megfestették.</translation>
        </message>
        <message>
            <source>Lens radius</source>
            <translation>Lencse sugara</translation>
        </message>
        <message>
            <source>Blurs what is out of focus (shader Path); 0 is a pinhole.</source>
            <translation>Elmossa, ami nem éles (Útkövetés árnyaló); 0: lyukkamera.</translation>
        </message>
        <message>
            <source>Focus distance</source>
            <translation>Élesség távolsága</translation>
        </message>
        <message>
            <source>How far away things are sharp; 0: at the target.</source>
            <translation>Milyen messze éles a kép; 0: a célpontnál.</translation>
        </message>
        <message>
            <source>Path</source>
            <translation>Útkövetés</translation>
        </message>
        <message>
            <source>Materials</source>
            <translation>Anyagok</translation>
        </message>
        <message>
            <source>Objects</source>
            <translation>Tárgyak</translation>
        </message>
        <message>
            <source>Standard (sRGB)</source>
            <translation>Szokásos (sRGB)</translation>
        </message>
        <message>
            <source>Filmic</source>
            <translation>Filmszerű</translation>
        </message>
        <message>
            <source>Blend</source>
            <translation>Keverés</translation>
        </message>
        <message>
            <source>Mask</source>
            <translation>Maszk</translation>
        </message>
        <message>
            <source>Opaque</source>
            <translation>Átlátszatlan</translation>
        </message>
        <message>
            <source>Y up</source>
            <translation>Y felfelé</translation>
        </message>
        <message>
            <source>Z up</source>
            <translation>Z felfelé</translation>
        </message>
        <message>
            <source>Turns the image about the vertical axis.</source>
            <translation>A függőleges tengely körül forgatja a képet.</translation>
        </message>
        <message>
            <source>How often light may bounce; Whitted follows 6 bounces at most.</source>
            <translation>Ahányszor a fény visszaverődhet; a Whitted legfeljebb 6-ot követ.</translation>
        </message>
        <message>
            <source>Transparent shadows</source>
            <translation>Átlátszó árnyékok</translation>
        </message>
        <message>
            <source>Glass lets light straight through in its shadow.</source>
            <translation>Az üveg az árnyékában egyenesen átengedi a fényt.</translation>
        </message>
        <message>
            <source>Firefly limit</source>
            <translation>Kiugró minták határa</translation>
        </message>
        <message>
            <source>Brightest radiance that one indirect sample may add; 0: no limit. Darkens the picture.</source>
            <translation>A legfényesebb érték, amit egy közvetett minta hozzáadhat; 0: nincs határ. Sötétíti a képet.</translation>
        </message>
        <message>
            <source>Seed</source>
            <translation>Mag</translation>
        </message>
        <message>
            <source>Another number, other noise.</source>
            <translation>Más szám, más zaj.</translation>
        </message>
        <message>
            <source>View</source>
            <translation>Színek</translation>
        </message>
        <message>
            <source>How radiance becomes colours of the screen; EXR files stay linear.</source>
            <translation>Hogyan lesz a fényből a képernyő színe; az EXR-fájlok lineárisak maradnak.</translation>
        </message>
        <message>
            <source>Denoise preview</source>
            <translation>Zajszűrt előnézet</translation>
        </message>
        <message>
            <source>Smooths the picture on the screen along surfaces; files stay as they are.</source>
            <translation>A képernyő képét a felületek mentén simítja; a fájlok nem változnak.</translation>
        </message>
        <message>
            <source>Where the object's origin is, in its group's space.</source>
            <translation>Ahol a tárgy origója van, a csoportja terében.</translation>
        </message>
        <message>
            <source>Seen by camera</source>
            <translation>A kamera látja</translation>
        </message>
        <message>
            <source>Otherwise one sees it only in mirrors and by its shadow.</source>
            <translation>Különben csak tükrökben és az árnyékáról látszik.</translation>
        </message>
        <message>
            <source>Seen in reflections</source>
            <translation>Tükröződésekben látszik</translation>
        </message>
        <message>
            <source>Light that was reflected or refracted meets it; otherwise mirrors do not show it.</source>
            <translation>A visszavert és megtört fény eléri; különben a tükrök nem mutatják.</translation>
        </message>
        <message>
            <source>Casts shadows</source>
            <translation>Árnyékot vet</translation>
        </message>
        <message>
            <source>It stops the light of lights.</source>
            <translation>Feltartja a fényforrások fényét.</translation>
        </message>
        <message>
            <source>Solo</source>
            <translation>Egyedül</translation>
        </message>
        <message>
            <source>While any light is solo, only those that are shine.</source>
            <translation>Amíg bármelyik fényforrás egyedüli, csak az ilyenek világítanak.</translation>
        </message>
        <message>
            <source>What the group is called in the scene tree.</source>
            <translation>A csoport neve a fában.</translation>
        </message>
        <message>
            <source>A hidden group hides all that is in it.</source>
            <translation>A rejtett csoport mindent elrejt, ami benne van.</translation>
        </message>
        <message>
            <source>Where the group's origin is; its members move with it.</source>
            <translation>Ahol a csoport origója van; tagjai vele mozognak.</translation>
        </message>
        <message>
            <source>Size along each axis; its members grow with it.</source>
            <translation>Méret tengelyenként; tagjai vele nőnek.</translation>
        </message>
        <message>
            <source>Rays</source>
            <translation>Sugarak</translation>
        </message>
    </context>
</TS>
