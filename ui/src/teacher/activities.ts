import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { classesApi } from "../api/classes";
import type { ActivityTitle } from "../api/model";
import { report } from "../app/session";
import { language } from "../i18n";

const activities = signal<ActivityTitle[]>([]);

/** The missions that a lesson may be about, in the language of the page. */
export function useActivities(): ActivityTitle[] {
  useEffect(() => {
    classesApi.activities().then((found) => {
      activities.value = found;
    }, report);
  }, [language.value]);
  return activities.value;
}
