export const TABS = ["python", "ir"] as const;

export type TextTab = (typeof TABS)[number];

/**
 * State of the drawer: text or plots, the form of the text, whether it covers the floor, whether Python is being edited.
 */
export interface DrawerState {
  readonly open: boolean;
  readonly what: "text" | "plots";
  readonly tab: TextTab;
  readonly tall: boolean;
  readonly editing: boolean;
}

export const DRAWER: DrawerState = {
  open: false,
  what: "text",
  tab: "python",
  tall: false,
  editing: false,
};
