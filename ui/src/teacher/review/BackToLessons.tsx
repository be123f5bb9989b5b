import { ArrowLeft } from "lucide-preact";
import { texts } from "../../i18n";
import { LinkButton } from "../../kit/LinkButton";
import { hashOf } from "../../shell/route";

/** Link from the review to the list of lessons. */
export function BackToLessons() {
  return (
    <LinkButton
      class="back-to-lessons"
      icon={ArrowLeft}
      label={texts.value.review.lesson.back}
      href={hashOf({ screen: "teacher", part: "lessons" })}
    />
  );
}
