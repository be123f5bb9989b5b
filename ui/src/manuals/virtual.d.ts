/** Made by ui/manuals.ts from pages of docs/. */
declare module "virtual:manuals" {
  interface ManualsModule {
    readonly manuals: readonly import("./model").Manual[];
  }
  /** The languages that have manuals; those of each are fetched when they are needed. */
  export const rows: Readonly<Record<string, () => Promise<ManualsModule>>>;
}
