import { activitiesApi } from "../api/activities";
import { classesApi, NO_CLASS } from "../api/classes";
import { api } from "../api/client";
import type { Group, Program } from "../api/model";
import { versionsApi } from "../api/versions";
import { texts } from "../i18n";
import { setClassroom } from "../shell/classroom";
import { go } from "../shell/route";

/** After this time the next screen is on display and receives the second click of a double click. */
const SHOWN_MS = 100;
const pending = new Set<string>();

/** Ignores a second call with the same key while the first is pending: a double click acts once. */
async function once(key: string, enter: () => Promise<void>): Promise<void> {
  if (pending.has(key)) return;
  pending.add(key);
  const wait = () => setTimeout(() => pending.delete(key), SHOWN_MS);
  await enter().finally(wait);
}

/**
 * Opens a group's program for the activity of the lesson. Without an activity, opens the group's
 * newest program. If the program does not exist, creates it. If the group has unread notes of the
 * teacher, opens the group's work instead. Also selects the group's class on the start screen.
 */
export function enterGroup(group: Group): Promise<void> {
  return once(`enter ${group.id}`, () => enter(group));
}

/** Number of the last card that was pressed: the answers for an earlier one may come later. */
let newest = 0;

async function enter(group: Group): Promise<void> {
  const own = ++newest;
  setClassroom(group.classroom_id ?? NO_CLASS);
  const [notes, activity] = await Promise.all([unseenNotes(group), activityOfLesson(group)]);
  if (own !== newest) return;
  if (notes.length > 0) return go({ screen: "work", group: group.id });
  const program = activity
    ? await activitiesApi.begin(group.id, activity)
    : await newestProgram(group.id);
  if (own === newest) go({ screen: "studio", program: program.id });
}

async function newestProgram(group: string): Promise<Program> {
  const [newest] = await api.programs(group);
  return newest ?? createProgram(group, []);
}

/** The activity of the class's open lesson. If the lesson fails to load, the group still gets to its work. */
async function activityOfLesson({ classroom_id }: Group): Promise<string | null> {
  if (!classroom_id) return null;
  const now = await classesApi.currentLesson(classroom_id).catch(() => null);
  return now?.lesson?.activity ?? null;
}

/** If the notes fail to load, the group still gets to its work; the notes appear the next time. */
function unseenNotes(group: Group) {
  return versionsApi.unseenNotes(group.id).catch(() => []);
}

/** Creates a program for a group and opens it. */
export function startProgram(groupId: string, others: readonly Program[]): Promise<void> {
  return once(`start ${groupId}`, async () => {
    const { id } = await createProgram(groupId, others);
    go({ screen: "studio", program: id });
  });
}

/** Creates a program with the first free numbered name: "Programa 1", "Programa 2". */
function createProgram(groupId: string, others: readonly Program[]): Promise<Program> {
  const usedNames = new Set(others.map((program) => program.name));
  let number = others.length + 1;
  while (usedNames.has(texts.value.start.firstProgram({ n: number }))) number += 1;
  return api.createProgram(groupId, texts.value.start.firstProgram({ n: number }));
}
