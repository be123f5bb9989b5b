import { albumApi } from "../api/album";
import { language, texts } from "../i18n";
import { useLoaded } from "../kit/requests/useLoaded";
import { hashOf } from "../shell/route";
import { StickerPicture } from "./StickerPicture";
import { titleOf } from "./words";

interface NewStickersProps {
  group: string;
  /** The run that passed its mission. */
  run: string;
}

/** Which stickers a run has won, as a link to the album. While it loads, its place stays free. */
export function NewStickers({ group, run }: NewStickersProps) {
  const album = useLoaded([group, run, language.value], () => albumApi.of(group), {
    onFailed: () => {}, // the mission is passed all the same
  });
  if (album.status === "failed") return null;
  if (album.status !== "ready") return <span class="new-stickers" aria-hidden="true" />;
  const won = album.value.stickers.filter(({ win }) => win?.run_id === run);
  if (won.length === 0) return null;
  const names = won.map((one) => titleOf(one, texts.value));
  const titles = new Intl.ListFormat(language.value).format(names);
  const text = texts.value.album.news({ count: won.length, titles });
  return (
    <a
      class="new-stickers row middle gap-2"
      href={hashOf({ screen: "album", group })}
      data-testid="new-stickers"
    >
      {won.map(({ name }) => (
        <StickerPicture key={name} name={name} won />
      ))}
      <span class="shrinks">{text}</span>
    </a>
  );
}
