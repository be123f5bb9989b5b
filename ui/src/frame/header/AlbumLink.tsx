import { Sticker } from "lucide-preact";
import { texts } from "../../i18n";
import { LinkButton } from "../../kit/LinkButton";
import { hashOf } from "../../shell/route";
import { group } from "../../shell/session";
import { reviewOrigin } from "../../shell/teacher/review_origin";

/** Link to the group's album of stickers, unless the teacher switched it off for the class. */
export function AlbumLink() {
  const { value: now } = group;
  if (!now?.has_album || reviewOrigin.value) return null;
  const { album } = texts.value.titles;
  return (
    <LinkButton
      class="header__album"
      icon={Sticker}
      label={album}
      href={hashOf({ screen: "album", group: now.id })}
      testId="open-album"
    >
      <span class="header__word header__album-word">{album}</span>
    </LinkButton>
  );
}
