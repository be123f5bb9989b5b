import { ArrowRight } from "lucide-preact";
import type { Merged } from "../../api/model";
import { texts } from "../../i18n";
import { LinkButton } from "../../kit/LinkButton";
import { hashOf } from "../../shell/route";
import { titleOf } from "../lessons/lessons";

interface MergedLessonsProps {
  results: readonly Merged[];
}

/** Links to the newest lesson of each merged file, each lesson once. */
export function MergedLessons({ results }: MergedLessonsProps) {
  const { lessons: labels } = texts.value.teacher;
  const lessons = new Map(results.flatMap(({ lesson }) => (lesson ? [[lesson.id, lesson]] : [])));
  if (lessons.size === 0) return null;
  return (
    <div class="button-row exchange__lessons">
      {[...lessons.values()].map((lesson) => (
        <LinkButton
          key={lesson.id}
          kind="main"
          iconEnd={ArrowRight}
          href={hashOf({ screen: "lesson", lesson: lesson.id })}
          testId="merged-lesson"
        >
          {labels.reviewOf({ title: titleOf(lesson) })}
        </LinkButton>
      ))}
    </div>
  );
}
