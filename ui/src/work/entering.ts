import { NO_CLASS } from "../api/classes";
import { api } from "../api/client";
import type { Group, Program } from "../api/model";
import { versionsApi } from "../api/versions";
import { texts } from "../i18n";
import { setClassroom } from "../shell/classroom";
import { go } from "../shell/route";

/** By then the other screen is there, and takes the second click of a double click. */
const SHOWN_MS = 100;
const onTheWay = new Set<string>();

/** Who clicks twice wants one thing. */
async function once(wish: string, enter: () => Promise<void>): Promise<void> {
  if (onTheWay.has(wish)) return;
  onTheWay.add(wish);
  const wait = () => setTimeout(() => onTheWay.delete(wish), SHOWN_MS);
  await enter().finally(wait);
}

/**
 * Opens the newest program of a group, or its first one, made now; a letter of the teacher is read before. The start
 * screen shows the group's class when it comes back.
 */
export function enterGroup(group: Group): Promise<void> {
  return once(`enter ${group.id}`, () => enter(group));
}

async function enter(group: Group): Promise<void> {
  setClassroom(group.classroom_id ?? NO_CLASS);
  const [[newest], notes] = await Promise.all([api.programs(group.id), unseenNotes(group)]);
  if (notes.length > 0) return go({ screen: "work", group: group.id });
  const program = newest ?? (await createProgram(group.id, []));
  go({ screen: "studio", program: program.id });
}

/** Nobody is kept out by a letter that cannot be fetched: it is there the next time. */
function unseenNotes(group: Group) {
  return versionsApi.unseenNotes(group.id).catch(() => []);
}

/** Makes one more program for a group, and opens it. */
export function startProgram(groupId: string, others: readonly Program[]): Promise<void> {
  return once(`start ${groupId}`, async () => {
    const { id } = await createProgram(groupId, others);
    go({ screen: "studio", program: id });
  });
}

/** Makes a program with the first free name of its kind: "Programa 1", "Programa 2". */
function createProgram(groupId: string, others: readonly Program[]): Promise<Program> {
  const taken = new Set(others.map((program) => program.name));
  let number = others.length + 1;
  while (taken.has(texts.value.start.firstProgram(number))) number += 1;
  return api.createProgram(groupId, texts.value.start.firstProgram(number));
}
