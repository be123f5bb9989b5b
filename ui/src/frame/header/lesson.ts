import { signal } from "@preact/signals";
import { classesApi } from "../../api/classes";
import { ServerGone } from "../../api/errors";
import { group, report } from "../../shell/session";

/** What the open group's class is about now, in the words of the teacher. */
export interface LessonWords {
  title: string;
  activity: string;
}

export const lesson = signal<LessonWords | null>(null);

/** Asks what lesson is open for the class of the group in the header. */
export async function knowLesson(): Promise<void> {
  const id = group.peek()?.classroom_id;
  try {
    const found = id ? await wordsOf(id) : null;
    if (group.peek()?.classroom_id === id) lesson.value = found;
  } catch (error) {
    // the page itself says when the server has gone; a lesson is no reason to say anything else
    if (error instanceof ServerGone) report(error);
  }
}

async function wordsOf(classroom: string): Promise<LessonWords | null> {
  const now = await classesApi.currentLesson(classroom);
  if (!now?.title) return null;
  const activities = now.activity ? await classesApi.activities() : [];
  const activity = activities.find((one) => one.name === now.activity)?.title ?? "";
  return { title: now.title, activity };
}
