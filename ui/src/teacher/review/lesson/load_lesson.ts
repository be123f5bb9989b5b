import { classesApi, NO_CLASS } from "../../../api/classes";
import type { LessonReview } from "../../../api/model";
import { reviewApi } from "../../../api/review";
import { language } from "../../../i18n";
import { withDistinctNames } from "../../../shell/namesakes";

/** A lesson with the lessons joined to it. */
export interface LessonPage {
  review: LessonReview;
  /** Name of the class; null for groups without a class. */
  classroom: string | null;
  /** Titles of the lesson's activities. */
  activities: readonly string[];
}

/** The review of a lesson, with names in the language of the page. */
export async function loadLesson(id: string): Promise<LessonPage> {
  const review = await reviewApi.lesson(id);
  const { id: whole, classroom_id } = review.lesson;
  const [classrooms, activities, lessons] = await Promise.all([
    classesApi.classrooms(),
    classesApi.activities(),
    classesApi.lessons(classroom_id ?? NO_CLASS),
  ]);
  const parts = lessons.filter((one) => one.part_of === whole);
  const named = [review.lesson, ...parts].flatMap(({ activity }) => activity ?? []);
  const classroom = withDistinctNames(classrooms, language.value).find(
    (one) => one.id === classroom_id,
  );
  return {
    review,
    classroom: classroom?.name ?? null,
    activities: [...new Set(named)].map(
      (name) => activities.find((one) => one.name === name)?.title ?? name,
    ),
  };
}
