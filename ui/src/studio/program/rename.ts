import { api } from "../../api/client";
import { STORE_LIMITS } from "../../api/declared";
import { program, report } from "../../shell/session";

/** Renames the program in the header; ignores an empty or equal name. */
export async function renameProgram(requested: string): Promise<void> {
  const { value: now } = program;
  const name = requested.trim().slice(0, STORE_LIMITS.MAX_NAME).trim();
  if (!now || !name || name === now.name) return;
  program.value = { ...now, name };
  try {
    program.value = await api.renameProgram(now.id, name);
  } catch (error) {
    program.value = now;
    report(error);
  }
}
