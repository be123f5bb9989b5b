"""The process that judges runs of activities, so that neither a long check nor a crash of one disturbs the app."""
