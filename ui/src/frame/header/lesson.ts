import { signal } from "@preact/signals";
import { classesApi } from "../../api/classes";
import { ServerGone } from "../../api/errors";
import type { GoalPicture } from "../../api/model";
import { group, report } from "../../shell/session";

/** Title and activity of the lesson that is open for a class. */
export interface LessonWords {
  title: string;
  activity: string;
  /** Null without an activity. */
  goal: GoalPicture | null;
}

export const lesson = signal<LessonWords | null>(null);

/** Loads the open lesson of the class of the group in the header. */
export async function loadOpenLesson(): Promise<void> {
  const id = group.peek()?.classroom_id;
  try {
    const found = id ? await wordsOf(id) : null;
    if (group.peek()?.classroom_id === id) lesson.value = found;
  } catch (error) {
    // other failures are not reported: the lesson is not worth an error line
    if (error instanceof ServerGone) report(error);
  }
}

async function wordsOf(classroom: string): Promise<LessonWords | null> {
  const now = await classesApi.currentLesson(classroom);
  if (!now?.title) return null;
  const activities = now.activity ? await classesApi.activities() : [];
  const activity = activities.find((one) => one.name === now.activity);
  return {
    title: now.title,
    activity: activity?.title ?? "",
    goal: activity?.goal_picture ?? null,
  };
}
