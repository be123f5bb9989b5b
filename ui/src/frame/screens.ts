import type { ComponentType } from "preact";
import { lazyScreen } from "../shell/lazy";
import type { ScreenName } from "../shell/route";
import { StartScreen } from "../start/StartScreen";
import { StudioScreen } from "../studio/StudioScreen";

type Screen = ComponentType<never>;
/** A file of a screen exports its component by the name of the file. */
type File = Readonly<Record<string, Screen>>;

/** Screens of the first bundle; all others are loaded on demand. */
const FIRST: Partial<Record<ScreenName, Screen>> = { start: StartScreen, studio: StudioScreen };

const FILES = import.meta.glob<File>([
  "../**/*Screen.tsx",
  "!../start/StartScreen.tsx",
  "!../studio/StudioScreen.tsx",
]);

const LAZY = Object.entries(FILES).map(([path, load]) => {
  const component = path.replace(/^.*\/|\.tsx$/g, "");
  const name = component.replace(/Screen$/, "").toLowerCase();
  return [name, async () => (await load())[component] as Screen] as const;
});

/** Imports a screen; none for those of the first bundle. */
export const LOADS: Partial<Record<string, () => Promise<Screen>>> = Object.fromEntries(LAZY);

/** The component of each screen: that of `runs` is `RunsScreen` in `RunsScreen.tsx`, in whichever folder. */
export const PARTS: Partial<Record<string, Screen>> = {
  ...FIRST,
  ...Object.fromEntries(LAZY.map(([name, load]) => [name, lazyScreen(load)])),
};
