import { api } from "../api/client";
import { group, program } from "./session";

/** Sets program and group of the header; requests them only if they have changed. */
export async function nameInHeader(programId: string | null, groupId?: string | null) {
  if (program.value?.id !== programId) {
    program.value = programId ? await api.program(programId) : null;
  }
  const owner = groupId === undefined ? (program.value?.group_id ?? null) : groupId;
  if (group.value?.id === owner) return;
  const groups = owner ? await api.groups() : [];
  group.value = groups.find((one) => one.id === owner) ?? null;
}
