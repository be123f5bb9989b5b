import { activitiesApi } from "../api/activities";
import { go } from "./route";

/** Opens a group's program for an activity, created if there is none. */
export async function beginActivity(group: string, activity: string): Promise<void> {
  const { id } = await activitiesApi.begin(group, activity);
  go({ screen: "studio", program: id });
}
