/** The screens of the version history, imported as one chunk. */
export { DifferencesScreen } from "./DifferencesScreen";
export { VersionsScreen } from "./VersionsScreen";
