import type { Lesson } from "../../api/model";
import { texts } from "../../i18n";

/** A lesson with the lessons joined to it. */
export interface LessonGroup {
  lesson: Lesson;
  parts: Lesson[];
}

/** Lessons in order, each with its parts; a part whose lesson is missing is listed alone. */
export function withParts(lessons: readonly Lesson[]): LessonGroup[] {
  const ids = new Set(lessons.map((one) => one.id));
  const isPart = (one: Lesson) => one.part_of !== null && ids.has(one.part_of);
  return lessons
    .filter((one) => !isPart(one))
    .map((lesson) => ({ lesson, parts: lessons.filter((one) => one.part_of === lesson.id) }));
}

/** The lesson to which the others will be joined: the first with a title, else the oldest. */
export function whole(lessons: readonly Lesson[]): Lesson | undefined {
  const oldestFirst = [...lessons].sort((a, b) => (a.opened_at < b.opened_at ? -1 : 1));
  return oldestFirst.find((one) => one.title) ?? oldestFirst[0];
}

export function titleOf(lesson: Lesson): string {
  return lesson.title || texts.value.teacher.lessons.untitled;
}
