import { authoringApi } from "../../../api/authoring";
import { api } from "../../../api/client";
import { documentOf, SHAPES, type Shape } from "./pattern";

/** The names of the programs on this page, with the length of a side; it is by them that they are found again. */
export type Names = Record<Shape, string>;
export type ProgramIds = Partial<Record<Shape, string>>;

/** The programs of the pattern among those of the teacher. */
export async function findPrograms(names: Names): Promise<ProgramIds> {
  const own = (await api.groups()).find(({ of_teacher }) => of_teacher);
  const programs = own ? await api.programs(own.id) : [];
  return Object.fromEntries(
    SHAPES.flatMap((shape) => {
      const found = programs.find(({ name }) => name === names[shape]);
      return found ? [[shape, found.id]] : [];
    }),
  );
}

/** Makes those programs of the pattern that are missing. */
export async function makePrograms(names: Names, side: number, found: ProgramIds): Promise<void> {
  const { contentOf } = await import("../../../editor/content_of");
  for (const shape of SHAPES.filter((one) => !found[one])) {
    const { id } = await authoringApi.newProgram();
    await api.saveVersion(id, contentOf(documentOf(shape, side)));
    await api.renameProgram(id, names[shape]);
  }
}
