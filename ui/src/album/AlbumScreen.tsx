import { Printer } from "lucide-preact";
import { albumApi } from "../api/album";
import type { Album, Sticker } from "../api/model";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { usePrintedPage } from "../shell/files/printed_page";
import { canPrint, printPage } from "../shell/files/printing";
import { nameInHeader } from "../shell/named";
import type { ParametersOf } from "../shell/route";
import { group, program } from "../shell/session";
import { type Chapter, chaptersOf, onPaper, printLayout } from "./chapters";
import { Place } from "./Place";

/** The album of a group: a sticker for each passed mission, and places for those to come. */
export function AlbumScreen({ group: id }: ParametersOf<"album">) {
  const album = useLoaded([id, language.value], () => load(id));
  return (
    <Loaded of={album} as="screen">
      {({ enabled, stickers }) =>
        enabled ? <Pages group={id} stickers={stickers} /> : <SwitchedOff />
      }
    </Loaded>
  );
}

async function load(id: string): Promise<Album> {
  const { value: shown } = program;
  const named = nameInHeader(shown?.group_id === id ? shown.id : null, id);
  const [album] = await Promise.all([albumApi.of(id), named]);
  // the teacher may have switched albums on or off since the group was loaded
  if (group.value) group.value = { ...group.value, has_album: album.enabled };
  return album;
}

interface PagesProps {
  group: string;
  stickers: readonly Sticker[];
}

function Pages({ group: id, stickers }: PagesProps) {
  usePrintedPage("album");
  const { album: labels, plan } = texts.value;
  const chapters = chaptersOf(stickers);
  const printed = chapters.map((chapter) => onPaper(chapter).length).filter((size) => size > 0);
  const paper = printLayout(printed);
  const won = stickers.filter((one) => one.win).length;
  return (
    <main
      class="screen album"
      data-notes={paper.withNotes}
      style={{ "--paper-columns": paper.columns, "--paper-side": `${paper.side.toFixed(1)}mm` }}
    >
      <div class="album__head row middle apart gap-4">
        <div class="shrinks">
          <h1 dir="auto">{labels.titleOf({ group: group.value?.name ?? "" })}</h1>
          <p class="album__about">
            <strong data-testid="album-count">{labels.count({ won, all: stickers.length })}</strong>{" "}
            {labels.about}
          </p>
        </div>
        {canPrint() && (
          <Button class="rigid" icon={Printer} testId="album-print" onPress={printPage}>
            {plan.print}
          </Button>
        )}
      </div>
      {chapters.map((chapter) => (
        <ChapterPart key={chapter.name} chapter={chapter} group={id} />
      ))}
    </main>
  );
}

interface ChapterPartProps {
  chapter: Chapter;
  group: string;
}

function ChapterPart({ chapter, group: id }: ChapterPartProps) {
  const { name, stickers } = chapter;
  const { activity, album } = texts.value;
  const title = name === "character" ? album.character : activity.paths[name];
  const printed = onPaper(chapter);
  return (
    <section
      class="album__chapter"
      data-paper={printed.length > 0}
      aria-labelledby={`album-${name}`}
    >
      <h2 id={`album-${name}`}>{title}</h2>
      <ul class="album__places">
        {stickers.map((sticker) => (
          <li key={sticker.name} data-paper={printed.includes(sticker)}>
            <Place sticker={sticker} group={id} />
          </li>
        ))}
      </ul>
    </section>
  );
}

function SwitchedOff() {
  const { album } = texts.value;
  return (
    <main class="screen album album--off" data-testid="album-off">
      <h1>{album.offTitle}</h1>
      <p>{album.off}</p>
    </main>
  );
}
