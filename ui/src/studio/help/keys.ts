import type { Texts } from "../../i18n";
import { EMERGENCY_KEY } from "../../run/real/real_robot";
import { ACTIONS } from "../run_bar/actions";

export interface KeyRow {
  /** Alternatives, each of keys pressed together. */
  readonly keys: readonly string[];
  readonly words: string;
}

export interface KeyGroup {
  readonly title: string;
  readonly rows: readonly KeyRow[];
  /** Keys that a sentence names. */
  readonly more?: readonly string[];
}

/** All keys of the studio. What a button does too is said in the words of the button. */
export function keyGroups(texts: Texts): KeyGroup[] {
  const { keys } = texts.help;
  const { studio, scene } = texts;
  return [
    { title: texts.run.bar, rows: [...runRows(texts), emergencyRow(texts)] },
    {
      title: keys.blocks,
      rows: [
        { keys: ["T"], words: keys.palette },
        { keys: ["W"], words: keys.program },
        { keys: ["↑", "↓", "←", "→"], words: keys.arrows },
        { keys: ["Enter"], words: keys.enter },
        { keys: ["M"], words: keys.move },
        { keys: ["Delete"], words: keys.remove },
        { keys: ["Ctrl+C", "Ctrl+V"], words: keys.copy },
        { keys: ["Ctrl+Z"], words: studio.undo },
        { keys: ["Ctrl+Shift+Z"], words: studio.redo },
        { keys: ["Esc"], words: keys.escape },
        { keys: ["Tab"], words: keys.tab },
      ],
    },
    { title: studio.floor, rows: [], more: [scene.startKeys, scene.measureKeys] },
  ];
}

const emergencyRow = ({ robot }: Texts): KeyRow => ({
  keys: [EMERGENCY_KEY],
  words: robot.emergencyHelp,
});

/** Actions that share a key share its row: one of them is possible at a time. */
function runRows(texts: Texts): KeyRow[] {
  const state = { phase: "idle", unable: false, inFunction: false, stepwise: true } as const;
  const rows = new Map<string, string[]>();
  for (const { shortcut, label, help } of ACTIONS) {
    const words = help?.(texts) ?? label(texts, state);
    rows.set(shortcut, [...(rows.get(shortcut) ?? []), words]);
  }
  return [...rows].map(([key, words]) => ({ keys: [key], words: words.join(", ") }));
}
