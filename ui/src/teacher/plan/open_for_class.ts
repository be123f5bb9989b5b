import { classesApi } from "../../api/classes";
import type { ActivityChoice, Lesson } from "../../api/model";

/** What the plan needs to know of a class. */
export interface PlanClass {
  /** The lesson that the teacher opened and that goes on; null without one. */
  readonly current: Lesson | null;
  readonly activities: readonly ActivityChoice[];
}

export async function loadPlanClass(classroom: string | null): Promise<PlanClass> {
  const [now, activities] = await Promise.all([
    classroom ? classesApi.currentLesson(classroom) : null,
    classesApi.activities(),
  ]);
  const current = now?.lesson ?? null;
  return { current: current?.by_itself === false ? current : null, activities };
}

/** Makes an activity that of the open lesson, so that the whole plan is one lesson; opens one where there is none. */
export async function openForClass(
  classroom: string,
  current: Lesson | null,
  title: string,
  activity: string,
): Promise<void> {
  if (current) await classesApi.changeLesson(current.id, { activity });
  else await classesApi.openLesson(classroom, { title, activity });
}
