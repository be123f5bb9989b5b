import type { Sticker } from "../api/model";
import { language, type Texts, texts } from "../i18n";
import { Button } from "../kit/Button";
import { beginActivity } from "../shell/begin_activity";
import { hashOf } from "../shell/route";
import { StickerPicture } from "./StickerPicture";
import { dayOf, howOf, titleOf } from "./words";

interface PlaceProps {
  sticker: Sticker;
  group: string;
}

/** A place of the album. A sticker leads to the run that won it, the place of a mission to the mission. */
export function Place({ sticker, group }: PlaceProps) {
  const { album } = texts.value;
  const { win, name, kind } = sticker;
  const title = titleOf(sticker, texts.value);
  const card = { class: "album__place", "data-testid": "album-place", "data-sticker": name };
  const contents = <Contents sticker={sticker} labels={texts.value} />;
  if (win?.run_id) {
    const href = hashOf({ screen: "replay", run: win.run_id });
    return (
      <a {...card} href={href} title={album.see({ title })} data-won="true">
        {contents}
      </a>
    );
  }
  if (win || kind === "character") {
    return (
      <div {...card} data-won={win !== null}>
        {contents}
      </div>
    );
  }
  return (
    <Button
      kind="bare"
      class="album__place"
      testId="album-place"
      tip={album.begin({ title })}
      data-sticker={name}
      data-won="false"
      onPress={() => beginActivity(group, name)}
    >
      {contents}
    </Button>
  );
}

interface ContentsProps {
  sticker: Sticker;
  labels: Texts;
}

function Contents({ sticker, labels }: ContentsProps) {
  const { album } = labels;
  const { win, name, n_done, n_needed } = sticker;
  return (
    <>
      <StickerPicture name={name} won={win !== null} />
      <strong class="album__name" dir="auto">
        {titleOf(sticker, labels)}
      </strong>
      <span class="album__note">
        {win ? (
          album.wonOn({ date: dayOf(win.won_at, language.value) })
        ) : (
          <>
            <span class="visually-hidden">{`${album.empty}. `}</span>
            {howOf(sticker, labels)}
            {n_needed > 1 && (
              <span class="album__progress">{album.progress({ n: n_done, all: n_needed })}</span>
            )}
          </>
        )}
      </span>
    </>
  );
}
